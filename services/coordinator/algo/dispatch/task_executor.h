#pragma once

#include <functional>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/stage/task.h"

namespace slicefarm::coordinator {

/// Runs all tasks of a job somewhere, in any order, with retries as it sees fit.
class TaskExecutor {
 public:
  virtual ~TaskExecutor() = default;

  /// Results are in the order of `tasks`, which are all of one process. `layers_done` is told, from
  /// any thread but one call at a time, how many layers are finished. Errors: the first task's that
  /// cannot be made, or Cancelled.
  virtual absl::StatusOr<std::vector<TaskResult>> Execute(
      const StageCall& call, std::span<const Task> tasks,
      const std::function<void(int32_t)>& layers_done) = 0;

  /// How many tasks of a process can be worked on at once: what a job is cut for.
  virtual int Slots(Process process) const = 0;
};

}  // namespace slicefarm::coordinator
