#pragma once

#include <chrono>
#include <string>

#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm::cli {

/// Returns "in about 2m 10s" for a job whose end the farm expects, "soon" if that time has come,
/// and nothing if no end is expected.
std::string EndText(const v1::Job& job, std::chrono::system_clock::time_point now);

/// Returns "place 3 in the queue, done in about 2m 10s", as far as the farm knows it of a job that
/// waits; empty if it knows nothing.
std::string QueueText(const v1::Job& job, std::chrono::system_clock::time_point now);

}  // namespace slicefarm::cli
