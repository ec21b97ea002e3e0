#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/base/shared/shared.h"
#include "common/model/layer_warning.h"
#include "common/model/layers/fill_stats.h"
#include "common/model/layers/job_plan.h"
#include "common/stage/task.h"

namespace slicefarm {

struct FdmShared;

/// A range of layers to print, with all its inputs.
struct FdmTask {
  static constexpr Process kProcess = Process::kFdm;

  LayerRange range;
  std::span<const SlicedLayer> layers;  ///< layers of the range and its halo
  std::span<const LayerPlan> plans;     ///< one per layer of the range
  Shared<FdmShared> job;

  int32_t Weight() const { return range.size(); }
  TaskLabel Label() const { return LabelOf(range); }
};

/// Result of an FDM task.
struct FdmResult {
  std::vector<LayerProgram> programs;
  std::vector<LayerWarning> warnings;
  /// Totals sorted by layer, summed over all copies. Within a layer they are sorted as in AddUse.
  std::vector<FillStats> fills;
  StageTimes times;

  size_t Print() const;
  int64_t ProgramBytes() const;
};

using FdmRunner = RunnerOf<FdmTask, FdmResult>;

}  // namespace slicefarm
