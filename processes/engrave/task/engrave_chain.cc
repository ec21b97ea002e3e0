#include "processes/engrave/task/engrave_chain.h"

#include <utility>

#include "common/base/stopwatch.h"

namespace slicefarm {

absl::StatusOr<EngraveResult> EngraveChain::Run(const StageCall& call,
                                                const EngraveTask& task) const {
  EngraveResult result;
  auto layers = Timed(result.times[Stage::kTexture],
                      [&] { return texture_.Engrave(call, task.input, task.range); });
  if (!layers.ok()) return layers.status();
  result.layers = *std::move(layers);
  return result;
}

}  // namespace slicefarm
