#pragma once

#include "absl/status/status.h"
#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm::cli {

/// Returns true if the job is in a final state.
bool HasEnded(const v1::Job& job);

/// Returns OK if the job has succeeded; otherwise the server's reason for the missing result.
absl::Status OutcomeOf(const v1::Job& job);

}  // namespace slicefarm::cli
