#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/stage/stage_list.h"
#include "common/stage/task.h"

namespace slicefarm {

/// The stages and the runner that make the tasks of a process.
struct TaskChain {
  Process process;
  std::vector<Stage> stages;  ///< called in this order
  std::shared_ptr<const TaskRunner> runner;
};

/// Returns the chains for which all stages exist, in the order of Process.
std::vector<TaskChain> ChainsOver(const Stages& stages);

/// Returns the stages that tasks of the process use.
std::vector<Stage> TaskStagesOf(Process process);

}  // namespace slicefarm
