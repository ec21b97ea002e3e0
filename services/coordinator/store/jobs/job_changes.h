#pragma once

#include <cstdint>
#include <functional>
#include <map>
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

/// How far a run of a job has come.
struct JobProgress {
  int64_t epoch = 0;    ///< of the claim under which it runs
  int64_t time_us = 0;  ///< when it was so
  int32_t layers_total = 0;
  int32_t layers_done = 0;

  friend bool operator==(const JobProgress&, const JobProgress&) = default;
};

/// Of all jobs that a coordinator runs, which no store keeps.
struct ProgressReport {
  std::string owner;
  std::map<std::string, JobProgress> jobs;  ///< by id; at most kMostReported count

  friend bool operator==(const ProgressReport&, const ProgressReport&) = default;
};

/// What PostgreSQL takes in a notice.
inline constexpr size_t kMostReported = 80;

/// REQUIRES: owner and ids have no white space.
std::string ToText(const ProgressReport& report);
std::optional<ProgressReport> ProgressReportFromText(std::string_view text);

/// Tells of the changes that others, and this process too, write to a store, and of what others
/// tell besides.
class JobChanges {
 public:
  /// Called from one thread, which is none of those who write.
  struct Listener {
    /// None: some may have been missed, so anything may have changed.
    std::function<void(const std::optional<JobChange>& change)> changed;
    std::function<void(ProgressReport report)> progressed = [](const ProgressReport&) {};
  };

  virtual ~JobChanges() = default;

  /// Tells the others, some time later; the last report of those that come meanwhile.
  virtual void Tell(const ProgressReport& report) = 0;
};

}  // namespace slicefarm::coordinator
