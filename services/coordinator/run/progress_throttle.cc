#include "services/coordinator/run/progress_throttle.h"

namespace slicefarm::coordinator {
namespace {

constexpr double kEveryS = 0.2;
constexpr int32_t kSteps = 100;

}  // namespace

bool ProgressThrottle::Passes(const PipelineProgress& progress, double now_s) {
  const int32_t step = progress.total / kSteps + 1;
  const bool first = told_.total == 0;
  if (!first && (now_s - told_at_s_ < kEveryS || progress.done - told_.done < step)) {
    return false;
  }
  told_ = progress;
  told_at_s_ = now_s;
  return true;
}

}  // namespace slicefarm::coordinator
