#pragma once

#include <optional>
#include <string_view>

namespace slicefarm::coordinator {

/// The life of a job. A job ends exactly once: SUCCEEDED, FAILED and CANCELLED are left by nothing.
///
///   QUEUED -> RUNNING -> SUCCEEDED | FAILED | CANCELLED
///   QUEUED -> CANCELLED                    cancelled before it began
///   QUEUED -> SUCCEEDED                    found in the cache
///   QUEUED -> FAILED                       its input cannot be read
///   RUNNING -> QUEUED                      its coordinator stops and hands it back
enum class JobState { kQueued, kRunning, kSucceeded, kFailed, kCancelled };

bool IsTerminal(JobState state);

bool MayFollow(JobState from, JobState to);

/// "QUEUED", "RUNNING", ...: what the store keeps and logs show.
std::string_view JobStateName(JobState state);
std::optional<JobState> JobStateFromName(std::string_view name);

}  // namespace slicefarm::coordinator
