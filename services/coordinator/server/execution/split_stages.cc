#include "services/coordinator/server/execution/split_stages.h"

#include <algorithm>
#include <utility>

namespace slicefarm::coordinator {

SplitStages::SplitStages(const Names& names,
                         const std::function<StagePoolOptions(const std::string& stage)>& options,
                         StagePool& motion, StagePool* exposure, const rpc::JsonLog& log)
    : beading_pool_("beading", names.beading, log, options("beading")),
      infill_pool_("infill", names.infill, log, options("infill")),
      ordering_pool_("ordering", names.ordering, log, options("ordering")),
      motion_pool_(motion),
      exposure_pool_(exposure) {
  if (exposure != nullptr) exposure_.emplace(*exposure);
}

std::vector<Runner> SplitStages::AsRunners(int slots) {
  std::vector<Runner> runners;
  Runner fdm;
  fdm.name = "split stages";
  fdm.tasks = std::make_shared<LayerChain>(beading_, infill_, ordering_, motion_);
  fdm.await_ready = [this](std::chrono::milliseconds patience) {
    const auto pools = {&beading_pool_, &infill_pool_, &ordering_pool_, &motion_pool_};
    return std::ranges::all_of(pools, [&](StagePool* pool) { return pool->AwaitReady(patience); });
  };
  AddTwice(std::move(fdm), slots, runners);
  if (!exposure_) return runners;
  Runner laser;
  laser.name = "exposure";
  laser.tasks = std::make_shared<LaserChain>(*exposure_);
  laser.await_ready = [pool = exposure_pool_](std::chrono::milliseconds patience) {
    return pool->AwaitReady(patience);
  };
  AddTwice(std::move(laser), slots, runners);
  return runners;
}

void SplitStages::AddTwice(Runner runner, int slots, std::vector<Runner>& runners) {
  runner.slots = (slots + 1) / 2;
  runners.push_back(runner);
  runner.slots = std::max(slots / 2, 1);
  runners.push_back(std::move(runner));
}

std::map<std::string, const StagePool*> SplitStages::Pools() const {
  return {{"beading", &beading_pool_}, {"infill", &infill_pool_}, {"ordering", &ordering_pool_}};
}

}  // namespace slicefarm::coordinator
