#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "services/coordinator/algo/job_state.h"
#include "services/coordinator/store/jobs/job_record.h"

namespace slicefarm::coordinator {

/// A step in the life of a job, as coordinators that share a store tell each other of it.
struct JobChange {
  std::string job_id;
  JobState state = JobState::kQueued;
  bool cancel_requested = false;

  friend bool operator==(const JobChange&, const JobChange&) = default;
};

std::string ToText(const JobChange& change);
std::optional<JobChange> JobChangeFromText(std::string_view text);

/// Tells of the changes that others, and this process too, write to a store.
class JobChanges {
 public:
  /// Called from a thread of its own; none: some may have been missed, so anything may have
  /// changed.
  using Listener = std::function<void(const std::optional<JobChange>& change)>;

  virtual ~JobChanges() = default;
};

}  // namespace slicefarm::coordinator
