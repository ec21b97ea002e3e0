#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/base/shared/shared.h"
#include "common/stage/task.h"
#include "processes/mill/model/mill_input.h"
#include "processes/mill/model/milled_step.h"

namespace slicefarm {

/// A range of steps of one phase to mill.
struct MillTask {
  static constexpr Process kProcess = Process::kMill;

  StepRange steps;
  MillPhase phase = MillPhase::kRoughing;
  int32_t phase_first = 0;  ///< index of the range's first step within the phase, from 0
  int32_t weight = 0;
  Shared<MillInput> input;

  int32_t Weight() const { return weight; }
  /// Returns a label such as "roughing level 4", "finishing levels 3 to 9" or "rest rows 10 to 40".
  TaskLabel Label() const;
};

/// Result of a milling task.
struct MillResult {
  std::vector<MilledStep> steps;
  StageTimes times;

  size_t Print() const;
  /// Returns the approximate size of the program that is made from the task: one line per point.
  int64_t ProgramBytes() const;
};

using MillRunner = RunnerOf<MillTask, MillResult>;

}  // namespace slicefarm
