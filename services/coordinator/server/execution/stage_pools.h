#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "common/stage/stage_list.h"
#include "services/coordinator/algo/dispatch/runner_set.h"
#include "services/coordinator/remote/remote_stage_set.h"
#include "services/coordinator/remote/stage_pool.h"

namespace slicefarm::coordinator {

/// The stages that are services of their own: the replicas of each, and a client over them.
class StagePools {
 public:
  /// `names`: addresses by stage; of a stage without, there is none. `options`: of the pool of a
  /// stage, by its name.
  StagePools(const std::map<Stage, std::vector<std::string>>& names,
             const std::function<StagePoolOptions(const std::string& stage)>& options,
             const rpc::JsonLog& log);

  Stages stages() const { return stages_.all(); }
  /// REQUIRES: it is there.
  ReplicaSource& replicas(Stage stage) { return *pools_.at(stage); }
  /// Whether the replicas of these stages, so far as they are there, are of this build.
  bool AreOfThisBuild(const std::vector<Stage>& stages);

  /// The chain of each process whose task stages are there, as two runners of `slots` tasks at a
  /// time together, at least one each: a task is doubled and given up by the rules of FanOut, which
  /// speak of more than one. They can be reached when all their stages can. The object must outlive
  /// the runners' calls.
  std::vector<Runner> AsRunners(int slots);

  /// By name.
  std::map<std::string, const StagePool*> Pools() const;

 private:
  std::map<Stage, std::unique_ptr<StagePool>> pools_;
  RemoteStageSet stages_;
};

}  // namespace slicefarm::coordinator
