#pragma once

#include <cstdint>

#include "absl/status/statusor.h"
#include "services/coordinator/run/lost_runs.h"
#include "services/coordinator/run/run_wishes.h"

namespace slicefarm::coordinator {

/// The way of one claimed job, as a pure state machine: it says what is to be done next, and is
/// told what came of it.
///
///   kFindCached -> kBegin -> kCompute -> kKeep -> kOver
///        each of them, when it fails -> kConclude -> kOver
///
/// Whoever lost the job takes no further step: all but kCompute write. Who is to give it up does
/// not begin with it: a job whose end was requested does not end with an earlier result. What
/// LostRuns lets not begin does not either: it is for Conclusion to say when it runs again, if it
/// does.
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
  explicit RunSteps(const LostRuns& lost_runs) : lost_runs_(lost_runs) {}

  /// The step to take now.
  Step Next(const RunWishes& wishes, int64_t now_us);

  /// The step was taken: the job has ended by it as SUCCEEDED, or goes on; or why it failed.
  void Took(const absl::StatusOr<bool>& succeeded);

  /// Why the job did not succeed; OK as long as nothing failed.
  const absl::Status& status() const { return status_; }

 private:
  LostRuns lost_runs_;
  Step step_ = Step::kFindCached;
  absl::Status status_;
};

}  // namespace slicefarm::coordinator
