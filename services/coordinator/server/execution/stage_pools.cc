#include "services/coordinator/server/execution/stage_pools.h"

#include <algorithm>
#include <utility>

#include "processes/list/jobs.h"
#include "processes/list/tasks.h"

namespace slicefarm::coordinator {
namespace {

void AddTwice(Runner runner, int slots, std::vector<Runner>& runners) {
  runner.slots = (slots + 1) / 2;
  runners.push_back(runner);
  runner.slots = std::max(slots / 2, 1);
  runners.push_back(std::move(runner));
}

}  // namespace

StagePools::StagePools(const std::map<Stage, std::vector<std::string>>& names,
                       const std::function<StagePoolOptions(const std::string& stage)>& options,
                       const rpc::JsonLog& log) {
  for (const auto& [stage, addresses] : names) {
    if (addresses.empty()) continue;
    const std::string name(StageName(stage));
    pools_[stage] = std::make_unique<StagePool>(name, addresses, log, options(name));
    stages_.Add(stage, *pools_[stage]);
  }
}

bool StagePools::AreOfThisBuild(Process process) {
  return std::ranges::all_of(JobStagesOf(process), [&](Stage stage) {
    const auto pool = pools_.find(stage);
    return pool == pools_.end() || pool->second->OfThisBuild();
  });
}

std::vector<std::string> StagePools::Away(Process process) const {
  std::vector<std::string> away;
  for (const Stage stage : JobStagesOf(process))
    if (const auto pool = pools_.find(stage); pool != pools_.end() && pool->second->IsAway())
      away.emplace_back(StageName(stage));
  return away;
}

std::vector<Runner> StagePools::AsRunners(int slots) {
  std::vector<Runner> runners;
  for (TaskChain& chain : ChainsOver(stages_.all())) {
    std::vector<StagePool*> pools;
    for (const Stage stage : chain.stages) pools.push_back(pools_.at(stage).get());
    Runner runner;
    runner.name = pools.size() == 1 ? std::string(StageName(chain.stages.front())) : "split stages";
    runner.tasks = std::move(chain.runner);
    runner.await_ready = [pools](std::chrono::milliseconds patience) {
      return std::ranges::all_of(pools,
                                 [&](StagePool* pool) { return pool->AwaitReady(patience); });
    };
    AddTwice(std::move(runner), slots, runners);
  }
  return runners;
}

std::map<std::string, const StagePool*> StagePools::Pools() const {
  std::map<std::string, const StagePool*> pools;
  for (const auto& [stage, pool] : pools_) pools[std::string(StageName(stage))] = pool.get();
  return pools;
}

}  // namespace slicefarm::coordinator
