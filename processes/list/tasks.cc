#include "processes/list/tasks.h"

#include "processes/engrave/task/engrave_chain.h"
#include "processes/fdm/task/layer_chain.h"
#include "processes/laser/task/laser_chain.h"
#include "processes/mill/task/mill_chain.h"

namespace slicefarm {
namespace {

/// Returns the runner of a process over these stages, or null if a stage is missing.
std::shared_ptr<const TaskRunner> RunnerOver(const Stages& stages, Process process) {
  switch (process) {
    case Process::kFdm:
      return LayerChain::Over(stages);
    case Process::kLaser:
      return LaserChain::Over(stages);
    case Process::kMill:
      return MillChain::Over(stages);
    case Process::kEngrave:
      return EngraveChain::Over(stages);
  }
  return nullptr;
}

}  // namespace

std::vector<Stage> TaskStagesOf(Process process) {
  switch (process) {
    case Process::kFdm:
      return LayerChain::StagesOf();
    case Process::kLaser:
      return LaserChain::StagesOf();
    case Process::kMill:
      return MillChain::StagesOf();
    case Process::kEngrave:
      return EngraveChain::StagesOf();
  }
  return {};
}

std::vector<TaskChain> ChainsOver(const Stages& stages) {
  std::vector<TaskChain> chains;
  for (const ProcessInfo& info : kProcesses)
    if (auto runner = RunnerOver(stages, info.process))
      chains.push_back({info.process, TaskStagesOf(info.process), std::move(runner)});
  return chains;
}

}  // namespace slicefarm
