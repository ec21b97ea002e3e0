#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/base/shared/shared.h"
#include "common/stage/exposure_job.h"
#include "common/stage/exposure_stage.h"
#include "common/stage/task.h"
#include "processes/laser/model/exposed_program.h"

namespace slicefarm {

/// A range of layers to scan, with all its inputs.
struct LaserTask {
  static constexpr Process kProcess = Process::kLaser;

  LayerRange range;
  std::span<const SlicedLayer> layers;  ///< layers of the range and its halo
  Shared<ExposureJob> job;

  int32_t Weight() const { return range.size(); }
  TaskLabel Label() const { return LabelOf(range); }
};

/// Result of a laser task.
struct LaserResult {
  std::vector<ExposedProgram> programs;
  StageTimes times;

  size_t Print() const;
  int64_t ProgramBytes() const;
};

using LaserRunner = RunnerOf<LaserTask, LaserResult>;

}  // namespace slicefarm
