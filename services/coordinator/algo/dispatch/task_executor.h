#pragma once

#include <functional>
#include <span>

#include "absl/status/statusor.h"
#include "common/stage/task.h"

namespace slicefarm::coordinator {

/// Runs all tasks of a job somewhere, in any order, with retries as it sees fit.
class TaskExecutor {
 public:
  virtual ~TaskExecutor() = default;

  /// Takes the result of a task; an error ends the job with it.
  using TakeResult = std::function<absl::Status(size_t task, TaskResult result)>;

  /// Makes `tasks`, which are all of one process. `take` gets the result of each of them once, as
  /// soon as it is there, from any thread and several at a time. `weight_done` is told, from any
  /// thread but one call at a time, what the tasks weigh that are finished. Neither is called after
  /// the return. Errors: the first task's that cannot be made; those of `take`; Cancelled.
  virtual absl::Status Execute(const StageCall& call, std::span<const Task> tasks,
                               const TakeResult& take,
                               const std::function<void(int32_t)>& weight_done) = 0;

  /// How many tasks of a process can be worked on at once: what a job is cut for.
  virtual int Slots(Process process) const = 0;
};

}  // namespace slicefarm::coordinator
