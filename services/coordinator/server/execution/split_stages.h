#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "processes/fdm/task/layer_chain.h"
#include "processes/laser/task/laser_chain.h"
#include "services/coordinator/algo/dispatch/runner_set.h"
#include "services/coordinator/remote/remote_stages.h"
#include "services/coordinator/remote/stage_pool.h"

namespace slicefarm::coordinator {

/// The layer stages as services of their own: a chain whose calls go to whichever replicas there
/// are. All ranges in flight share it, as two runners: a range is doubled and given up by the rules
/// of FanOut, which speak of more than one.
class SplitStages {
 public:
  struct Names {
    std::vector<std::string> beading;
    std::vector<std::string> infill;
    std::vector<std::string> ordering;
  };

  /// `options` of the pool of a stage, by its name. `motion` and `exposure` must outlive it; null:
  /// no jobs of lasers are made.
  SplitStages(const Names& names,
              const std::function<StagePoolOptions(const std::string& stage)>& options,
              StagePool& motion, StagePool* exposure, const rpc::JsonLog& log);

  /// The chain of each process as two runners of `slots` ranges at a time together, at least one
  /// each; they can be reached when all stages can. The object must outlive the runners' calls.
  std::vector<Runner> AsRunners(int slots);

  /// The stages besides motion, by name.
  std::map<std::string, const StagePool*> Pools() const;

 private:
  static void AddTwice(Runner runner, int slots, std::vector<Runner>& runners);

  StagePool beading_pool_;
  StagePool infill_pool_;
  StagePool ordering_pool_;
  StagePool& motion_pool_;
  RemoteBeading beading_{beading_pool_};
  RemoteInfill infill_{infill_pool_};
  RemoteOrdering ordering_{ordering_pool_};
  RemoteMotion motion_{motion_pool_};
  StagePool* const exposure_pool_;
  std::optional<RemoteExposure> exposure_;
};

}  // namespace slicefarm::coordinator
