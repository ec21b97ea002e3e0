#pragma once

#include <cstdint>

#include "absl/status/statusor.h"
#include "services/coordinator/run/run_wishes.h"

namespace slicefarm::coordinator {

/// A job that lost so many runs may be what its coordinators die of.
inline constexpr int32_t kSuspectRuns = 3;

/// What a run of `job`, as it was claimed, is to write of lost runs: if it is RUNNING, this one may
/// be lost.
inline int32_t LostRunsAfter(const JobRecord& job, JobState state) {
  return job.lost_runs + (state == JobState::kRunning ? 1 : 0);
}

/// The way of one claimed job, as a pure state machine: it says what is to be done next, and is
/// told what came of it.
///
///   kFindCached -> kBegin -> kCompute -> kKeep -> kOver
///        each of them, when it fails -> kConclude -> kOver
///
/// Whoever lost the job takes no further step: all but kCompute write. Who is to give it up does
/// not begin with it: a job whose end was requested does not end with an earlier result. A suspect
/// whose last run was lost does not begin either: as JOB_POISONED, it is for Conclusion to say when
/// it runs again, if it does.
class RunSteps {
 public:
  enum class Step {
    kFindCached,  ///< end it with the result that the same work came to before
    kBegin,       ///< write RUNNING
    kCompute,     ///< meshes to G-code
    kKeep,        ///< write artifacts, and SUCCEEDED
    kConclude,    ///< write what the failure makes of it: run_conclusion.h
    kOver,
  };

  RunSteps() = default;
  /// Of a job as it was claimed.
  explicit RunSteps(const JobRecord& job)
      : lost_runs_(job.state == JobState::kRunning ? job.lost_runs : 0) {}

  /// The step to take now.
  Step Next(const RunWishes& wishes, int64_t now_us);

  /// The step was taken: the job has ended by it as SUCCEEDED, or goes on; or why it failed.
  void Took(const absl::StatusOr<bool>& succeeded);

  /// Why the job did not succeed; OK as long as nothing failed.
  const absl::Status& status() const { return status_; }

 private:
  int32_t lost_runs_ = 0;  ///< 0: the last one was not lost
  Step step_ = Step::kFindCached;
  absl::Status status_;
};

}  // namespace slicefarm::coordinator
