#pragma once

#include <any>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/layers/layer.h"
#include "common/model/process.h"
#include "common/stage/stage_call.h"
#include "common/stage/stage_list.h"
#include "common/stage/stages.h"

namespace slicefarm {

/// Description of a task, for people and logs.
struct TaskLabel {
  std::string text;  ///< description such as "layers 3 to 9"
  /// Numbers in the description, for programs: layer_first and layer_last.
  std::map<std::string, int64_t> numbers;

  friend bool operator==(const TaskLabel&, const TaskLabel&) = default;
};

/// Returns the label of a task for a range of layers.
TaskLabel LabelOf(LayerRange layers);

/// Piece of a job's work. One call of a TaskRunner does the whole task, or fails. Code that
/// distributes tasks uses only their process, weight and label. The payload's type depends on the
/// process (processes/<name>/task).
class Task {
 public:
  Task() = default;  ///< Makes an empty task.

  /// Makes a task from a payload: a value with kProcess, Weight() and Label(). The constructor is
  /// implicit, so that a payload can be passed as a task.
  template <class Payload>
  requires requires { Payload::kProcess; }
  Task(Payload payload)  // NOLINT(google-explicit-constructor)
      : process_(Payload::kProcess),
        weight_(payload.Weight()),
        label_(payload.Label()),
        payload_(std::move(payload)) {}

  Process process() const { return process_; }
  /// Returns the amount by which the finished task increases the job's progress.
  int32_t weight() const { return weight_; }
  const TaskLabel& label() const { return label_; }

  /// Returns the payload. REQUIRES: the task was made from a Payload.
  template <class Payload>
  const Payload& As() const {
    return *std::any_cast<Payload>(&payload_);
  }

 private:
  Process process_ = kDefaultProcess;
  int32_t weight_ = 0;
  TaskLabel label_;
  std::any payload_;
};

/// Result of a task of any process.
class TaskResult {
 public:
  TaskResult() = default;  ///< Makes an empty result.

  /// Makes a result from a value with `times`, Print() and ProgramBytes(). The constructor is
  /// implicit, so that the value can be passed as a result.
  template <class Result>
  requires requires(const Result& result) { result.ProgramBytes(); }
  TaskResult(Result result)  // NOLINT(google-explicit-constructor)
      : made_(std::make_unique<Of<Result>>(std::move(result))) {}

  // REQUIRES, for all functions below: the result was not made by the default constructor.

  const StageTimes& times() const { return made_->times(); }
  /// Returns a fingerprint of the program. Equal programs have equal fingerprints, even if the
  /// times differ. Fingerprints may only be compared within one process of the operating system.
  /// Cost: O(bytes).
  size_t Print() const { return made_->Print(); }
  /// Returns the number of bytes that the result adds to the job's program.
  int64_t ProgramBytes() const { return made_->ProgramBytes(); }

  /// Returns the result. REQUIRES: the TaskResult was made from a Result.
  template <class Result>
  Result& As() const {
    return static_cast<Of<Result>&>(*made_).result;
  }

 private:
  struct Made {
    virtual ~Made() = default;
    virtual const StageTimes& times() const = 0;
    virtual size_t Print() const = 0;
    virtual int64_t ProgramBytes() const = 0;
  };
  template <class Result>
  struct Of : Made {
    explicit Of(Result made) : result(std::move(made)) {}
    const StageTimes& times() const override { return result.times; }
    size_t Print() const override { return result.Print(); }
    int64_t ProgramBytes() const override { return result.ProgramBytes(); }
    Result result;
  };

  std::unique_ptr<Made> made_;
};

/// Interface for running tasks: either a chain of stages, or a worker elsewhere that runs the
/// chain.
class TaskRunner {
 public:
  virtual ~TaskRunner() = default;

  /// Returns the processes that the runner supports.
  virtual ProcessSet processes() const = 0;

  /// Runs a task. The result has the type of the task's process. REQUIRES: processes() contains the
  /// task's process.
  virtual absl::StatusOr<TaskResult> RunTask(const StageCall& call, const Task& task) const = 0;
};

/// Runner for tasks of one process.
template <class OneTask, class OneResult>
class RunnerOf : public TaskRunner {
 public:
  virtual absl::StatusOr<OneResult> Run(const StageCall& call, const OneTask& task) const = 0;

  ProcessSet processes() const final { return {OneTask::kProcess}; }
  absl::StatusOr<TaskResult> RunTask(const StageCall& call, const Task& task) const final {
    absl::StatusOr<OneResult> result = Run(call, task.As<OneTask>());
    if (!result.ok()) return result.status();
    return TaskResult(*std::move(result));
  }
};

/// Runner that passes each task to the runner of the task's process.
class ProcessRunners : public TaskRunner {
 public:
  /// Makes the runner. `runners`: at most one per process.
  explicit ProcessRunners(std::vector<std::shared_ptr<const TaskRunner>> runners)
      : runners_(std::move(runners)) {}

  ProcessSet processes() const override;
  absl::StatusOr<TaskResult> RunTask(const StageCall& call, const Task& task) const override;

 private:
  const std::vector<std::shared_ptr<const TaskRunner>> runners_;
};

}  // namespace slicefarm
