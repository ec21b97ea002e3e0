#include "processes/laser/task/laser_chain.h"

#include <utility>

#include "common/base/stopwatch.h"
#include "common/stage/object_layers.h"

namespace slicefarm {

absl::StatusOr<LaserResult> LaserChain::Run(const StageCall& call, const LaserTask& task) const {
  if (absl::Status ok = CheckHalo(task.layers, task.range, HaloLayers(task.job->settings));
      !ok.ok())
    return ok;
  LaserResult result;
  auto programs = Timed(result.times[Stage::kExposure], [&] {
    return exposure_.Expose(call, {task.range, task.layers}, task.job);
  });
  if (!programs.ok()) return programs.status();
  result.programs = *std::move(programs);
  return result;
}

}  // namespace slicefarm
