#include "services/coordinator/server/execution/split_stages.h"

#include <algorithm>
#include <utility>

namespace slicefarm::coordinator {

SplitStages::SplitStages(const Names& names,
                         const std::function<StagePoolOptions(const std::string& stage)>& options,
                         StagePool& motion, const rpc::JsonLog& log)
    : beading_pool_("beading", names.beading, log, options("beading")),
      infill_pool_("infill", names.infill, log, options("infill")),
      ordering_pool_("ordering", names.ordering, log, options("ordering")),
      motion_pool_(motion) {}

std::array<Runner, 2> SplitStages::AsRunners(int slots) {
  Runner runner;
  runner.name = "split stages";
  runner.tasks = std::make_shared<LayerChain>(beading_, infill_, ordering_, motion_);
  runner.await_ready = [this](std::chrono::milliseconds patience) { return AwaitReady(patience); };
  std::array<Runner, 2> runners = {runner, runner};
  runners[0].slots = (slots + 1) / 2;
  runners[1].slots = std::max(slots / 2, 1);
  return runners;
}

std::map<std::string, const StagePool*> SplitStages::Pools() const {
  return {{"beading", &beading_pool_}, {"infill", &infill_pool_}, {"ordering", &ordering_pool_}};
}

bool SplitStages::AwaitReady(std::chrono::milliseconds patience) {
  const auto pools = {&beading_pool_, &infill_pool_, &ordering_pool_, &motion_pool_};
  return std::ranges::all_of(pools, [&](StagePool* pool) { return pool->AwaitReady(patience); });
}

}  // namespace slicefarm::coordinator
