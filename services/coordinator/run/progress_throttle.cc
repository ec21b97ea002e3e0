#include "services/coordinator/run/progress_throttle.h"

namespace slicefarm::coordinator {
namespace {

constexpr double kEveryS = 0.2;
constexpr int32_t kSteps = 100;

}  // namespace

bool ProgressThrottle::Passes(const PipelineProgress& progress, double now_s) {
  const int32_t step = progress.total / kSteps + 1;
  const bool first = reported_.total == 0;
  if (!first && (now_s - reported_at_s_ < kEveryS || progress.done - reported_.done < step)) {
    return false;
  }
  reported_ = progress;
  reported_at_s_ = now_s;
  return true;
}

}  // namespace slicefarm::coordinator
