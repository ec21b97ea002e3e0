#pragma once

#include <cstdint>
#include <optional>

#include "absl/status/status.h"
#include "services/coordinator/store/jobs/job_record.h"

namespace slicefarm::coordinator {

/// Number of lost runs after which a job is a suspect: it may kill its coordinators.
inline constexpr int32_t kSuspectRuns = 3;

/// Number of lost runs after which a job is considered to kill its coordinators.
inline constexpr int32_t kMaxLostRuns = 10;

/// Number of deadly runs after which a job is considered to kill its workers or stages.
inline constexpr int32_t kMaxDeadlyRuns = 3;

/// Decides when a job with failed runs may begin its next run. A run is lost if it began but never
/// ended, because its coordinator died. A run is deadly if it ended because services died during
/// the run. Pure.
///
/// Runs are lost because the job kills its coordinators, or because something else kills them. The
/// second cause does not depend on the job, and shows in the coordinators' calm time: the time for
/// which a coordinator has run without losing a lease. A job with several lost runs (a suspect)
/// runs only on coordinators that have been calm for long enough. Each further lost run doubles the
/// required time.
///
/// - If coordinators are killed all the time, none is calm. The suspects wait, and no further run
///   is lost.
/// - If a coordinator is calm until the job runs and then dies, the run counts as lost. Soon
///   kMaxLostRuns is reached.
///
/// Workers and stages die for the same two reasons. So the next run after a deadly run also
/// requires a calm coordinator, which shows that the farm is calm.
class LostRuns {
 public:
  LostRuns() = default;

  /// Creates the state of a claimed job from its counts of lost and deadly runs. `calm_us`: calm
  /// time of the coordinator that has claimed the job.
  LostRuns(const JobRecord& job, int64_t calm_us);

  /// Returns OK if a run may begin now. Errors: JOB_POISONED.
  absl::Status MayBegin() const;

  /// Returns true if the job is considered to kill coordinators. If false, the job may run again
  /// after `rest_us`.
  bool condemned() const { return count_ >= kMaxLostRuns; }
  /// Returns the time that the job must wait before its next run.
  int64_t rest_us() const { return rest_us_; }

  /// Returns the time that the job must wait after one more deadly run. Returns nullopt if the job
  /// is then considered to kill services.
  std::optional<int64_t> RestAfterDeadlyRunUs() const;

  /// Returns the number of lost runs to write together with the new `state`. With RUNNING it is one
  /// more, because this run is lost if it never writes again.
  int32_t After(JobState state) const;

 private:
  int32_t count_ = 0;
  int32_t deadly_ = 0;
  int64_t number_ = 0;
  int64_t rest_us_ = 0;
};

}  // namespace slicefarm::coordinator
