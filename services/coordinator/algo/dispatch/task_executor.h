#pragma once

#include <functional>
#include <span>
#include <string>

#include "absl/status/statusor.h"
#include "common/stage/task.h"

namespace slicefarm::coordinator {

/// Runs all tasks of a job on some runners, in any order. Retries failed tasks at its own
/// discretion.
class TaskExecutor {
 public:
  virtual ~TaskExecutor() = default;

  /// Function that takes the result of a task. If it returns an error, the job ends with this
  /// error.
  using TakeResult = std::function<absl::Status(size_t task, TaskResult result)>;

  /// Runs `tasks`, which all have the same process. Calls `take` once per task as soon as its
  /// result exists, from any thread, several calls at a time. Calls `weight_done` with the total
  /// weight of the finished tasks, from any thread, one call at a time. Neither function is called
  /// after the return. Errors: the error of the first task that finally fails; errors of `take`;
  /// CANCELLED.
  virtual absl::Status Execute(const StageCall& call, std::span<const Task> tasks,
                               const TakeResult& take,
                               const std::function<void(int32_t)>& weight_done) = 0;

  /// Returns how many tasks of a process can run at once. A job is cut into tasks for this number
  /// of slots.
  virtual int Slots(Process process) const = 0;

  /// Returns why runners may not join, as `ADDRESS: error` of the first one by address. Returns an
  /// empty text if none is refused.
  virtual std::string Refusal() const { return ""; }
};

}  // namespace slicefarm::coordinator
