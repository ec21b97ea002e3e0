#include "processes/mill/task/mill_chain.h"

#include <utility>

#include "common/base/stopwatch.h"

namespace slicefarm {

absl::StatusOr<MillResult> MillChain::Run(const StageCall& call, const MillTask& task) const {
  MillResult result;
  auto steps = Timed(result.times[Stage::kMilling],
                     [&] { return milling_.Mill(call, task.input, task.steps); });
  if (!steps.ok()) return steps.status();
  result.steps = *std::move(steps);
  return result;
}

}  // namespace slicefarm
