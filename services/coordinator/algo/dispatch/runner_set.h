#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "common/stage/task.h"

namespace slicefarm::coordinator {

/// Executor of tasks: a remote worker, a chain of remote stages, or this program.
struct Runner {
  std::string name = {};  ///< address, for logs and errors
  /// Executes the tasks and reports the supported processes. Shared, because a call may outlive the
  /// runner's membership.
  std::shared_ptr<const TaskRunner> tasks;
  int slots = 1;  ///< number of calls that may be in flight at once
  /// Waits until the runner can be reached, for at most the given time. Returns true at once if it
  /// can be reached. The dispatcher calls it before each task, so that a dead runner does not use
  /// up a try. If empty, the runner can always be reached. Thread-safe.
  std::function<bool(std::chrono::milliseconds)> await_ready = {};
};

using RunnerId = int64_t;

/// Set of available runners. Runners may join and leave while jobs run. Thread-safe.
class RunnerSet {
 public:
  virtual ~RunnerSet() = default;

  /// Adds a runner and returns its id.
  virtual RunnerId Join(Runner runner) = 0;

  /// Removes the runner. It gets no more ranges, and its unfinished ranges are given to other
  /// runners. Results that it still delivers are accepted.
  virtual void Leave(RunnerId id) = 0;

  /// Records why the runner at `name` may not join, for messages about waiting jobs. An empty `why`
  /// removes the record.
  virtual void Refuse(const std::string& /*name*/, const std::string& /*why*/) {}
};

}  // namespace slicefarm::coordinator
