#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "services/coordinator/algo/dispatch/runner_set.h"

namespace slicefarm::coordinator {

/// Task that a runner is working on.
struct TaskAtWork {
  std::string job_id;
  std::string task;    ///< label of the task
  double since_s = 0;  ///< time since the start of the task, in seconds
};

/// Runner with its current tasks.
struct RunnerAtWork {
  std::string name;
  int slots = 0;
  std::vector<TaskAtWork> tasks;
};

/// Set of runners that also adds each of its runners to another RunnerSet. Records each call that a
/// runner gets, so that the runner's current tasks are known. Writes the time and the outcome of
/// each task to the span log of its job. Each call gets a span of its own in the job's trace.
/// Thread-safe.
class Fleet : public RunnerSet {
 public:
  /// Creates a fleet that adds all its runners to `runners`, which must outlive this object.
  explicit Fleet(RunnerSet& runners) : runners_(runners) {}

  RunnerId Join(Runner runner) override;
  void Leave(RunnerId id) override;
  void Refuse(const std::string& name, const std::string& why) override {
    runners_.Refuse(name, why);
  }

  /// Returns the runners and their current tasks, in the order in which the runners joined.
  std::vector<RunnerAtWork> Runners() const;

 private:
  class Watched;
  using WatchedPtr = std::shared_ptr<const Watched>;  // shared with calls that outlive a membership

  RunnerSet& runners_;
  mutable std::mutex mutex_;
  int64_t next_member_ = 1;
  std::map<RunnerId, WatchedPtr> members_;
};

}  // namespace slicefarm::coordinator
