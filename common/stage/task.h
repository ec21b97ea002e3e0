#pragma once

#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/process.h"
#include "common/stage/stages.h"

namespace slicefarm {

/// What each stage took, in seconds of wall time as the caller sees it.
struct StageTimes {
  double slicing_s = 0;
  double planning_s = 0;
  double beading_s = 0;
  double infill_s = 0;
  double ordering_s = 0;
  double motion_s = 0;
  double exposure_s = 0;

  void Add(const StageTimes& other);
};

/// A range of layers to print, with everything they depend on.
struct FdmTask {
  static constexpr Process kProcess = Process::kFdm;

  LayerRange range;
  std::span<const SlicedLayer> layers;  ///< the range and its halo
  std::span<const LayerPlan> plans;     ///< one for each layer of the range
  std::span<const Copy> copies;         ///< of the whole job
  const JobFacts* facts = nullptr;
  const JobSettings* settings = nullptr;
};

/// What a stage could not do as it was asked to, in one layer.
struct LayerWarning {
  int32_t layer = 0;
  int32_t plain_islands = 0;  ///< islands that fell back to walls of constant width

  friend bool operator==(const LayerWarning&, const LayerWarning&) = default;
};

struct FdmResult {
  std::vector<LayerProgram> programs;
  std::vector<LayerWarning> warnings;
  std::vector<FillUse> fills;  ///< by layer, of all copies; within a layer see AddUse
  StageTimes times;

  size_t Print() const;
  int64_t ProgramBytes() const;
};

/// A range of layers to scan, with everything they depend on.
struct LaserTask {
  static constexpr Process kProcess = Process::kLaser;

  LayerRange range;
  std::span<const SlicedLayer> layers;  ///< the range and its halo
  std::span<const Copy> copies;         ///< of the whole job
  const JobSettings* settings = nullptr;
};

struct LaserResult {
  std::vector<ExposedProgram> programs;
  StageTimes times;

  size_t Print() const;
  int64_t ProgramBytes() const;
};

/// A piece of a job's work: what one call of a runner makes, whole or not at all. One alternative a
/// process, in the order of Process. Who hands tasks out sees their process and their layers, and
/// nothing else of them.
using Task = std::variant<FdmTask, LaserTask>;
using TaskResult = std::variant<FdmResult, LaserResult>;

static_assert(std::variant_size_v<Task> == kProcessCount &&
              std::variant_size_v<TaskResult> == kProcessCount);

inline Process ProcessOf(const Task& task) {
  return std::visit([](const auto& of) { return of.kProcess; }, task);
}

inline const LayerRange& LayersOf(const Task& task) {
  return std::visit([](const auto& of) -> const LayerRange& { return of.range; }, task);
}

inline const StageTimes& TimesOf(const TaskResult& result) {
  return std::visit([](const auto& of) -> const StageTimes& { return of.times; }, result);
}

/// A number that two runs of a task have in common if their programs are the same; times may
/// differ. Good within this process only. Cost: O(bytes).
inline size_t PrintOf(const TaskResult& result) {
  return std::visit([](const auto& of) { return of.Print(); }, result);
}

/// What a result adds to the job's program.
inline int64_t ProgramBytesOf(const TaskResult& result) {
  return std::visit([](const auto& of) { return of.ProgramBytes(); }, result);
}

/// Makes tasks: a chain of stages (LayerChain), or a worker that runs one elsewhere.
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
    absl::StatusOr<OneResult> result = Run(call, std::get<OneTask>(task));
    if (!result.ok()) return result.status();
    return *std::move(result);
  }
};

using FdmRunner = RunnerOf<FdmTask, FdmResult>;
using LaserRunner = RunnerOf<LaserTask, LaserResult>;

/// Runners of several processes as one.
class ProcessRunners : public TaskRunner {
 public:
  /// One of each process at most; they must outlive this.
  explicit ProcessRunners(std::vector<const TaskRunner*> runners) : runners_(std::move(runners)) {}

  ProcessSet processes() const override;
  absl::StatusOr<TaskResult> RunTask(const StageCall& call, const Task& task) const override;

 private:
  const std::vector<const TaskRunner*> runners_;
};

}  // namespace slicefarm
