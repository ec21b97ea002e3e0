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

/// What people and logs are told of a task.
struct TaskLabel {
  std::string text;                        ///< "layers 3 to 9"
  std::map<std::string, int64_t> numbers;  ///< the same for programs: layer_first, layer_last

  friend bool operator==(const TaskLabel&, const TaskLabel&) = default;
};

/// Of a task that makes a range of layers.
TaskLabel LabelOf(LayerRange layers);

/// A piece of a job's work: what one call of a runner makes, whole or not at all. Who hands tasks
/// out sees their process, weight and label, and nothing else of them: the payload is what the
/// process made it (processes/<name>/task).
class Task {
 public:
  Task() = default;  ///< nothing to do

  /// `payload`: a value with kProcess, Weight() and Label(). Implicit, as a payload is a task.
  template <class Payload>
  requires requires { Payload::kProcess; }
  Task(Payload payload)  // NOLINT(google-explicit-constructor)
      : process_(Payload::kProcess),
        weight_(payload.Weight()),
        label_(payload.Label()),
        payload_(std::move(payload)) {}

  Process process() const { return process_; }
  int32_t weight() const { return weight_; }  ///< what it adds to the progress when it is made
  const TaskLabel& label() const { return label_; }

  /// REQUIRES: it was made of one.
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

/// What a task came to, of whatever process.
class TaskResult {
 public:
  TaskResult() = default;  ///< nothing

  /// `result`: a value with `times`, Print() and ProgramBytes(). Implicit, as for tasks.
  template <class Result>
  requires requires(const Result& result) { result.ProgramBytes(); }
  TaskResult(Result result)  // NOLINT(google-explicit-constructor)
      : made_(std::make_unique<Of<Result>>(std::move(result))) {}

  // REQUIRES, of all that follow: it is not nothing.

  const StageTimes& times() const { return made_->times(); }
  /// A number that two runs of a task have in common if their programs are the same; times may
  /// differ. Good within this process only. Cost: O(bytes).
  size_t Print() const { return made_->Print(); }
  /// What it adds to the job's program.
  int64_t ProgramBytes() const { return made_->ProgramBytes(); }

  /// REQUIRES: it was made of one.
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

/// Makes tasks: a chain of stages, or a worker that runs one elsewhere.
class TaskRunner {
 public:
  virtual ~TaskRunner() = default;

  /// What it can make.
  virtual ProcessSet processes() const = 0;

  /// The result is of the task's process. REQUIRES: processes() has it.
  virtual absl::StatusOr<TaskResult> RunTask(const StageCall& call, const Task& task) const = 0;
};

/// A runner of one process.
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

/// Runners of several processes as one.
class ProcessRunners : public TaskRunner {
 public:
  /// One of each process at most.
  explicit ProcessRunners(std::vector<std::shared_ptr<const TaskRunner>> runners)
      : runners_(std::move(runners)) {}

  ProcessSet processes() const override;
  absl::StatusOr<TaskResult> RunTask(const StageCall& call, const Task& task) const override;

 private:
  const std::vector<std::shared_ptr<const TaskRunner>> runners_;
};

}  // namespace slicefarm
