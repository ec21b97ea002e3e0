#pragma once

#include "absl/status/status.h"
#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm::cli {

/// Returns true for states after which nothing changes any more.
bool HasEnded(const v1::Job& job);

/// Returns OK for a job that succeeded; else the reason for which it has no result, as the server
/// gives it.
absl::Status OutcomeOf(const v1::Job& job);

}  // namespace slicefarm::cli
