#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/stage/task.h"
#include "processes/engrave/model/engrave_input.h"
#include "processes/engrave/model/engraved_layer.h"

namespace slicefarm {

/// A range of layers to engrave, in order of work.
struct EngraveTask {
  static constexpr Process kProcess = Process::kEngrave;

  LayerRange range;
  Shared<EngraveInput> input;

  int32_t Weight() const { return range.size(); }
  TaskLabel Label() const { return LabelOf(range); }
};

/// Result of an engraving task.
struct EngraveResult {
  std::vector<EngravedLayer> layers;
  StageTimes times;

  size_t Print() const;
  int64_t ProgramBytes() const;
};

using EngraveRunner = RunnerOf<EngraveTask, EngraveResult>;

}  // namespace slicefarm
