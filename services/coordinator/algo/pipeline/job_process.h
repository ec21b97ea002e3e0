#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/spooled_text.h"
#include "common/model/layers/filament_use.h"
#include "common/stage/slice_input.h"
#include "common/stage/slicing_stage.h"
#include "common/stage/task.h"
#include "services/coordinator/algo/dispatch/task_executor.h"

namespace slicefarm::coordinator {

struct JobInput {
  SliceInput meshes;
  JobSettings settings;
  std::string settings_text;  ///< effective settings as `key = value` lines, quoted at the end of
                              ///< the G-code
  std::vector<std::string> warnings = {};  ///< of the settings: the report begins with them
};

/// What a report tells of one process alone.
class OwnReport {
 public:
  virtual ~OwnReport() = default;

  virtual void AddTo(nlohmann::ordered_json& json) const = 0;
};

/// What a job came to, besides its program.
struct JobReport {
  std::vector<MeshReport> meshes;
  int32_t layer_count = 0;
  double object_height_mm = 0;
  double print_time_s = 0;
  std::string file_name;           ///< what the settings call the file; empty: nothing
  FilamentUse filament;            ///< none: the process takes none
  std::unique_ptr<OwnReport> own;  ///< of the process; null: nothing
  StageTimes stage_times;
  std::vector<std::string> warnings;  ///< such as what a mesh lacks
  std::vector<std::string> notes;     ///< what planning chose, and why
};

/// What a job will take, before it is made.
struct JobEstimate {
  double print_time_s = 0;
  FilamentUse filament;
  std::optional<int32_t> layers = {};      ///< if they are not those that were sliced
  std::vector<MeshReport> meshes = {};     ///< if nothing was sliced
  std::vector<std::string> warnings = {};  ///< about what is planned
};

struct JobOutput {
  SpooledText program;  ///< for the machine: G-code, or a file of the settings' output_format
  JobReport report;
};

/// A job between its first stages and its tasks. It holds what the tasks point into.
class PlannedJob {
 public:
  virtual ~PlannedJob() = default;

  /// What all its tasks weigh together.
  virtual int32_t Weight() const = 0;

  /// All work that is left, cut for so many slots; the result of the job does not depend on the
  /// cut. They point into this object. Errors: REQUEST_TOO_LARGE if a task would look at more
  /// outlines than a worker can hold.
  virtual absl::StatusOr<std::vector<Task>> Tasks(int slots) = 0;

  /// Takes the result of one of them, once; from any thread, several at a time. What is long goes
  /// to a spool. Errors: DISK_FULL, STORE_FAILED.
  virtual absl::Status Take(size_t task, TaskResult result) = 0;

  /// The tasks' results, in the tasks' order, put together. Called once, when all of them were
  /// taken. Errors: INTERNAL if layers are missing; NOTHING_TO_PRINT; those of stages that see the
  /// whole.
  virtual absl::StatusOr<JobOutput> Assemble(const StageCall& call) = 0;
};

/// How the jobs of one process become tasks: DESIGN section 1, "A process". One class a process;
/// pipeline, dispatcher, cache, watch and cancel are the same for all.
class JobProcess {
 public:
  virtual ~JobProcess() = default;

  virtual Process process() const = 0;

  /// The stages that see the whole job. Errors: theirs; NOTHING_TO_PRINT.
  virtual absl::StatusOr<std::unique_ptr<PlannedJob>> Plan(const StageCall& call,
                                                           JobInput input) const = 0;

  /// Whether Estimate looks at the outlines of all layers. If not, nothing is sliced for it: the
  /// job comes as it is, with its meshes.
  virtual bool EstimatesByOutlines() const { return true; }

  /// What the job will take, by its outlines; where the process can, and `executor` has slots for
  /// it, by a few tasks that are made. Errors: those of stages that see the whole job.
  virtual absl::StatusOr<JobEstimate> Estimate(const StageCall& call, SlicedJob sliced,
                                               JobInput input, TaskExecutor& executor) const = 0;
};

}  // namespace slicefarm::coordinator
