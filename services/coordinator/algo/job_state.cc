#include "services/coordinator/algo/job_state.h"

namespace slicefarm::coordinator {

bool IsTerminal(JobState state) {
  return state == JobState::kSucceeded || state == JobState::kFailed ||
         state == JobState::kCancelled;
}

bool MayFollow(JobState from, JobState to) {
  switch (from) {
    case JobState::kQueued:
      return to != JobState::kQueued;
    case JobState::kRunning:
      return to != JobState::kRunning;
    case JobState::kSucceeded:
    case JobState::kFailed:
    case JobState::kCancelled:
      return false;
  }
  return false;
}

std::string_view JobStateName(JobState state) {
  switch (state) {
    case JobState::kQueued:
      return "QUEUED";
    case JobState::kRunning:
      return "RUNNING";
    case JobState::kSucceeded:
      return "SUCCEEDED";
    case JobState::kFailed:
      return "FAILED";
    case JobState::kCancelled:
      return "CANCELLED";
  }
  return "";
}

std::optional<JobState> JobStateFromName(std::string_view name) {
  using enum JobState;
  for (const JobState state : {kQueued, kRunning, kSucceeded, kFailed, kCancelled}) {
    if (JobStateName(state) == name) return state;
  }
  return std::nullopt;
}

}  // namespace slicefarm::coordinator
