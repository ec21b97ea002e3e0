#include "services/coordinator/run/run_steps.h"

namespace slicefarm::coordinator {
namespace {

using Step = RunSteps::Step;

Step After(Step step) {
  switch (step) {
    case Step::kFindCached:
      return Step::kBegin;
    case Step::kBegin:
      return Step::kCompute;
    case Step::kCompute:
      return Step::kKeep;
    case Step::kKeep:
    case Step::kConclude:
    case Step::kOver:
      return Step::kOver;
  }
  return Step::kOver;
}

}  // namespace

Step RunSteps::Next(const RunRequests& wishes, int64_t now_us) {
  if (wishes.lost()) return Step::kOver;
  const bool begun = step_ != Step::kFindCached && step_ != Step::kBegin;
  if (!begun && wishes.GivenUp(now_us)) Took(absl::CancelledError("cancelled before it began"));
  if (step_ == Step::kBegin) {
    if (absl::Status may = lost_runs_.MayBegin(); !may.ok()) Took(may);
  }
  return step_;
}

void RunSteps::Took(const absl::StatusOr<bool>& succeeded) {
  if (step_ == Step::kConclude || (succeeded.ok() && *succeeded)) {
    step_ = Step::kOver;
  } else if (succeeded.ok()) {
    step_ = After(step_);
  } else {
    status_ = succeeded.status();
    step_ = Step::kConclude;
  }
}

}  // namespace slicefarm::coordinator
