#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/stage/stage_list.h"
#include "common/stage/task.h"

namespace slicefarm {

/// What makes the tasks of a process out of stages.
struct TaskChain {
  Process process;
  std::vector<Stage> stages;  ///< what it calls, in this order
  std::shared_ptr<const TaskRunner> runner;
};

/// The chains whose stages are all there, in the order of Process.
std::vector<TaskChain> ChainsOver(const Stages& stages);

/// The stages that tasks of the process go through.
std::vector<Stage> TaskStagesOf(Process process);

}  // namespace slicefarm
