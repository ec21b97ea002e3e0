#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "services/coordinator/algo/dispatch/runner_set.h"

namespace slicefarm::coordinator {

/// A task that is being worked on.
struct TaskAtWork {
  std::string job_id;
  std::string task;    ///< its label
  double since_s = 0;  ///< for how long
};

/// A runner, and what it has to do.
struct RunnerAtWork {
  std::string name;
  int slots = 0;
  std::vector<TaskAtWork> tasks;
};

/// Stands before the runners and sees each of their calls: who has what to do now, and, in the span
/// log of the job, what was done when and how it ended. Each call gets a span of its own in the
/// job's trace. Thread-safe.
class Fleet : public RunnerSet {
 public:
  /// `runners` must outlive it.
  explicit Fleet(RunnerSet& runners) : runners_(runners) {}

  RunnerId Join(Runner runner) override;
  void Leave(RunnerId id) override;

  /// In the order of their joining.
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
