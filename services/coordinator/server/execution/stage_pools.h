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

/// Stages that run as separate services: a pool of replicas and a client for each stage.
class StagePools {
 public:
  /// Creates the pools. `names`: addresses by stage; a stage without addresses gets no pool.
  /// `options`: returns the pool options for the name of a stage.
  StagePools(const std::map<Stage, std::vector<std::string>>& names,
             const std::function<StagePoolOptions(const std::string& stage)>& options,
             const rpc::JsonLog& log);

  /// Returns the clients of the stages.
  Stages stages() const { return stages_.all(); }
  /// Returns the replicas of a stage. REQUIRES: the stage has a pool.
  ReplicaSource& replicas(Stage stage) { return *pools_.at(stage); }
  /// Returns true if the replicas of the stages that the coordinator calls for jobs of a process
  /// are of this build. Ignores stages without a pool.
  bool AreOfThisBuild(Process process);

  /// Returns the names of the stages without a reachable server, among the stages that the
  /// coordinator calls for jobs of a process. Ignores stages without a pool.
  std::vector<std::string> Away(Process process) const;

  /// Returns runners for each process with pools for all its task stages. Each process gets two
  /// runners with `slots` tasks in total, at least one each. There are two, because FanOut needs a
  /// second runner for second copies and after failures. A runner is reachable if all its stages
  /// are. This object must outlive the runners' calls.
  std::vector<Runner> AsRunners(int slots);

  /// Returns the pools by the names of their stages.
  std::map<std::string, const StagePool*> Pools() const;

 private:
  std::map<Stage, std::unique_ptr<StagePool>> pools_;
  RemoteStageSet stages_;
};

}  // namespace slicefarm::coordinator
