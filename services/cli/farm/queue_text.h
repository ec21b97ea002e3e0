#pragma once

#include <chrono>
#include <string>

#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm::cli {

/// Returns "in about 2m 10s" for a job with an expected end, or "soon" if the expected end has
/// passed. Returns an empty text if no end is expected.
std::string EndText(const v1::Job& job, std::chrono::system_clock::time_point now);

/// Returns "place 3 in the queue, done in about 2m 10s" for a waiting job. A part that the farm
/// does not know is left out; empty if both are unknown.
std::string QueueText(const v1::Job& job, std::chrono::system_clock::time_point now);

}  // namespace slicefarm::cli
