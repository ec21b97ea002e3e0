#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "common/stage/task.h"

namespace slicefarm::coordinator {

/// Something that runs tasks of the processes it knows, and how many at once: a worker elsewhere, a
/// chain of remote stages, or this process.
struct Runner {
  std::string name = {};  ///< for logs and errors: an address
  std::shared_ptr<const TaskRunner>
      tasks;      ///< shared: a call may outlive the runner's membership
  int slots = 1;  ///< calls in flight
  /// Asked before each task: waits until the runner can be reached, at most for the given time,
  /// and tells whether it can; so a dead runner costs no task a try. At once when it can. Empty:
  /// it always can. Thread-safe.
  std::function<bool(std::chrono::milliseconds)> await_ready = {};
};

using RunnerId = int64_t;

/// The runners there are at the moment. They may join and leave while jobs run. Thread-safe.
class RunnerSet {
 public:
  virtual ~RunnerSet() = default;

  virtual RunnerId Join(Runner runner) = 0;

  /// No further ranges go to the runner; those it has are given to others as well. A result that
  /// still comes is taken.
  virtual void Leave(RunnerId id) = 0;
};

}  // namespace slicefarm::coordinator
