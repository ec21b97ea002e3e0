#pragma once

#include <cstdint>
#include <optional>

#include "absl/status/status.h"
#include "services/coordinator/store/jobs/job_record.h"

namespace slicefarm::coordinator {

/// Number of lost runs after which a job is a suspect: its coordinators may die of it.
inline constexpr int32_t kSuspectRuns = 3;

/// Number of lost runs after which a job is considered to kill its coordinators.
inline constexpr int32_t kMaxLostRuns = 10;

/// Number of deadly runs after which a job is considered to kill its workers or stages.
inline constexpr int32_t kMaxDeadlyRuns = 3;

/// Decides when a job with failed runs may begin its next run. A lost run began but did not end. A
/// deadly run ended because services died during the run. Pure.
///
/// Runs are lost because the job kills its coordinators, or because something else kills them. The
/// second cause does not depend on the job. It shows in the coordinators' calm time: the time that
/// a coordinator has lived without losing a lease. A suspect runs only on coordinators that have
/// been calm for long enough. Each loss doubles the required time.
///
/// - If coordinators are killed all the time, none is calm. The suspects wait, which costs time but
///   no run.
/// - If coordinators live until the job runs, each of its runs counts. The last run is soon
///   reached.
///
/// Services die of the same causes, so the same rule applies after a deadly run: a calm coordinator
/// indicates a calm farm.
class LostRuns {
 public:
  LostRuns() = default;

  /// Creates the state of a claimed job. `calm_us`: time that its coordinator has been calm.
  LostRuns(const JobRecord& job, int64_t calm_us);

  /// Returns OK if a run may begin. Errors: JOB_POISONED.
  absl::Status MayBegin() const;

  /// Returns true if the job is considered to kill coordinators. If false, the job may run again
  /// after `rest_us`.
  bool condemned() const { return count_ >= kMaxLostRuns; }
  /// Returns the time that the job must wait before its next run.
  int64_t rest_us() const { return rest_us_; }

  /// Returns the time that the job must wait after one more deadly run. Returns nullopt if the job
  /// is then considered to kill services.
  std::optional<int64_t> RestAfterDeadlyRunUs() const;

  /// Returns the number of lost runs that a run writes together with `state`. RUNNING counts as one
  /// more, because the run may never write again.
  int32_t After(JobState state) const;

 private:
  int32_t count_ = 0;
  int32_t deadly_ = 0;
  int64_t number_ = 0;
  int64_t rest_us_ = 0;
};

}  // namespace slicefarm::coordinator
