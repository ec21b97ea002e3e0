#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/base/shared/shared.h"
#include "common/model/layer_warning.h"
#include "common/model/layers/fill_use.h"
#include "common/model/layers/job_plan.h"
#include "common/stage/task.h"

namespace slicefarm {

struct FdmShared;

/// A range of layers to print, with everything they depend on.
struct FdmTask {
  static constexpr Process kProcess = Process::kFdm;

  LayerRange range;
  std::span<const SlicedLayer> layers;  ///< the range and its halo
  std::span<const LayerPlan> plans;     ///< one for each layer of the range
  Shared<FdmShared> job;

  int32_t Weight() const { return range.size(); }
  TaskLabel Label() const { return LabelOf(range); }
};

struct FdmResult {
  std::vector<LayerProgram> programs;
  std::vector<LayerWarning> warnings;
  std::vector<FillUse> fills;  ///< by layer, of all copies; within a layer see AddUse
  StageTimes times;

  size_t Print() const;
  int64_t ProgramBytes() const;
};

using FdmRunner = RunnerOf<FdmTask, FdmResult>;

}  // namespace slicefarm
