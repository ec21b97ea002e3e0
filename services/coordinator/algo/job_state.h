#pragma once

#include <optional>
#include <string_view>

namespace slicefarm::coordinator {

/// State of a job. A job ends exactly once: no transition leaves SUCCEEDED, FAILED or CANCELLED.
///
///   QUEUED -> RUNNING -> SUCCEEDED | FAILED | CANCELLED;
///   QUEUED -> CANCELLED                    the job is cancelled before it begins;
///   QUEUED -> SUCCEEDED                    the result is in the cache;
///   QUEUED -> FAILED                       the job's input cannot be read;
///   RUNNING -> QUEUED                      the run has failed and is repeated, or the coordinator
///                                          stops.
enum class JobState { kQueued, kRunning, kSucceeded, kFailed, kCancelled };

/// Returns true if no transition leaves the state.
bool IsTerminal(JobState state);

/// Returns true if a job may change from state `from` to state `to`.
bool MayFollow(JobState from, JobState to);

/// Returns the name that the store and the logs use: "QUEUED", "RUNNING", ...
std::string_view JobStateName(JobState state);
/// Returns the state with this name; nullopt if there is none.
std::optional<JobState> JobStateFromName(std::string_view name);

}  // namespace slicefarm::coordinator
