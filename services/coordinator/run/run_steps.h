#pragma once

#include <cstdint>

#include "absl/status/statusor.h"
#include "services/coordinator/run/run_wishes.h"

namespace slicefarm::coordinator {

/// A job that lost so many runs is to run with no other beside it, so that none is blamed for what
/// another one does.
inline constexpr int32_t kSuspectRuns = 3;
inline constexpr int32_t kMaxLostRuns = 10;

/// The way of one claimed job, as a pure state machine: it says what is to be done next, and is
/// told what came of it.
///
///   kFindCached -> kBegin -> kCompute -> kKeep -> kOver
///        each of them, when it fails -> kConclude -> kOver
///
/// Whoever lost the job takes no further step: all but kCompute write. Who is to give it up does
/// not begin with it: a job whose end was requested does not end with an earlier result. A job that
/// lost kMaxLostRuns runs fails as JOB_POISONED: it may be what its coordinators die of.
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

  /// `lost_runs`: of the job, up to now.
  explicit RunSteps(int32_t lost_runs = 0) : lost_runs_(lost_runs) {}

  /// The step to take now.
  Step Next(const RunWishes& wishes, int64_t now_us);

  /// The step was taken: the job has ended by it as SUCCEEDED, or goes on; or why it failed.
  void Took(const absl::StatusOr<bool>& succeeded);

  /// Why the job did not succeed; OK as long as nothing failed.
  const absl::Status& status() const { return status_; }

 private:
  const int32_t lost_runs_;
  Step step_ = Step::kFindCached;
  absl::Status status_;
};

}  // namespace slicefarm::coordinator
