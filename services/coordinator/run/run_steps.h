#pragma once

#include <cstdint>

#include "absl/status/statusor.h"
#include "services/coordinator/run/lost_runs.h"
#include "services/coordinator/run/run_requests.h"

namespace slicefarm::coordinator {

/// Sequence of the steps of one claimed job. A pure state machine: returns the next step and
/// receives the outcome of each step.
///
///   kFindCached -> kBegin -> kCompute -> kKeep -> kOver;
///        each of them, when it fails -> kConclude -> kOver.
///
/// A run that has lost its job takes no further step, because all steps except kCompute write to
/// the store. A run that must end before its job has begun goes to kConclude, so a cancelled job
/// does not end with a cached result. A run that LostRuns does not allow goes from kBegin to
/// kConclude. In kConclude, the job's next state is decided (run_conclusion.h).
class RunSteps {
 public:
  /// Steps of a run.
  enum class Step {
    kFindCached,  ///< end the job with the cached result of the same work, if there is one
    kBegin,       ///< write RUNNING
    kCompute,     ///< make the program from the meshes
    kKeep,        ///< write the artifacts, and SUCCEEDED
    kConclude,    ///< write the effect of the failure (run_conclusion.h)
    kOver,
  };

  RunSteps() = default;
  explicit RunSteps(const LostRuns& lost_runs) : lost_runs_(lost_runs) {}

  /// Returns the next step.
  Step Next(const RunRequests& wishes, int64_t now_us);

  /// Records the outcome of the last step: true if the job has ended as SUCCEEDED, false if the
  /// next step follows, or an error.
  void Took(const absl::StatusOr<bool>& succeeded);

  /// Returns the reason that the job did not succeed; OK as long as nothing has failed.
  const absl::Status& status() const { return status_; }

 private:
  LostRuns lost_runs_;
  Step step_ = Step::kFindCached;
  absl::Status status_;
};

}  // namespace slicefarm::coordinator
