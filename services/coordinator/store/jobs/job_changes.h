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

/// Notice of a new state of a job. Coordinators that share a store send it to each other.
struct JobChange {
  std::string job_id;
  JobState state = JobState::kQueued;
  bool cancel_requested = false;

  friend bool operator==(const JobChange&, const JobChange&) = default;
};

/// Returns the text of a notice.
std::string ToText(const JobChange& change);
/// Reads the text of a notice; nullopt if it is none.
std::optional<JobChange> JobChangeFromText(std::string_view text);

/// Progress of a run of a job.
struct JobProgress {
  int64_t epoch = 0;    ///< epoch of the run's lease
  int64_t time_us = 0;  ///< time of this progress
  int32_t layers_total = 0;
  int32_t layers_done = 0;

  friend bool operator==(const JobProgress&, const JobProgress&) = default;
};

/// Progress of all jobs that a coordinator runs. It is sent to other coordinators but not stored.
struct ProgressReport {
  std::string owner;
  /// Progress by job id; at most kMostReported jobs are sent.
  std::map<std::string, JobProgress> jobs;

  friend bool operator==(const ProgressReport&, const ProgressReport&) = default;
};

/// Largest number of jobs with their progress that fit into a notice of PostgreSQL.
inline constexpr size_t kMostReported = 80;

/// Returns the text of a notice. REQUIRES: the owner and the ids have no white space.
std::string ToText(const ProgressReport& report);
/// Reads the text of a notice; nullopt if it is none.
std::optional<ProgressReport> ProgressReportFromText(std::string_view text);

/// Receives notices of changes that any coordinator, including this one, writes to a shared store.
/// Also receives the progress reports of other coordinators.
class JobChanges {
 public:
  /// Functions that receive the notices. They are called on one thread, which never writes to the
  /// store.
  struct Listener {
    /// Receives a change. nullopt: some notices may have been missed, so any job may have changed.
    std::function<void(const std::optional<JobChange>& change)> changed;
    std::function<void(ProgressReport report)> progressed = [](const ProgressReport&) {};
  };

  virtual ~JobChanges() = default;

  /// Sends a report to the other coordinators some time later. If several reports arrive before
  /// that, only the last is sent.
  virtual void Publish(const ProgressReport& report) = 0;
};

}  // namespace slicefarm::coordinator
