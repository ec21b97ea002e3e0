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
#include "services/coordinator/algo/pipeline/print_shares.h"

namespace slicefarm::coordinator {

/// Meshes and settings of a job.
struct JobInput {
  SliceInput meshes;
  JobSettings settings;
  std::string settings_text;  ///< effective settings as `key = value` lines, quoted at the end of
                              ///< the G-code
  /// Warnings about the settings, which the report lists first
  std::vector<std::string> warnings = {};
};

/// Part of a report that exists only for one process.
class ProcessReport {
 public:
  virtual ~ProcessReport() = default;

  /// Adds the keys of this part to the report.
  virtual void AddTo(nlohmann::ordered_json& json) const = 0;
};

/// Result of a job without its program.
struct JobReport {
  std::vector<MeshReport> meshes;
  int32_t layer_count = 0;
  double object_height_mm = 0;
  double print_time_s = 0;
  std::string file_name;  ///< file name from the settings; empty if they give none
  FilamentUse filament;   ///< empty if the process uses no filament
  PrintShares shares;     ///< time and filament by copy; empty if the process does not divide them
  std::unique_ptr<ProcessReport>
      own;  ///< the process's own part of the report; null if it has none
  StageTimes stage_times;
  std::vector<std::string> warnings;  ///< warnings, for example about defects of a mesh
  std::vector<std::string> notes;     ///< choices of the planning stage, with their reasons
};

/// Estimated time, filament and layers of a job before its program is made.
struct JobEstimate {
  double print_time_s = 0;
  FilamentUse filament;
  /// Number of layers, if the program has another number than the sliced meshes.
  std::optional<int32_t> layers = {};
  std::vector<MeshReport> meshes = {};     ///< reports of the meshes, if nothing was sliced
  std::vector<std::string> warnings = {};  ///< warnings about the plan
};

/// Result of a job.
struct JobOutput {
  /// Program for the machine: G-code, or a file in the format of the setting `output_format`.
  SpooledText program;
  JobReport report;
};

/// Job after the stages that need the whole job have run, and before its tasks run. Owns the data
/// to which the tasks point.
class PlannedJob {
 public:
  virtual ~PlannedJob() = default;

  /// Returns the total weight of all tasks.
  virtual int32_t Weight() const = 0;

  /// Returns all remaining work, cut into tasks for `slots` slots. The result of the job does not
  /// depend on the cut. The tasks point into this object. Errors: REQUEST_TOO_LARGE if a task needs
  /// more outlines than a worker can hold.
  virtual absl::StatusOr<std::vector<Task>> Tasks(int slots) = 0;

  /// Takes the result of a task, once per task. May be called from any thread, several calls at a
  /// time. Writes long results to a spool. Errors: DISK_FULL, STORE_FAILED.
  virtual absl::Status Take(size_t task, TaskResult result) = 0;

  /// Joins the results of all tasks in the order of the tasks. Called once, after all results were
  /// taken. Errors: INTERNAL if layers are missing; NOTHING_TO_PRINT; errors of the stages that
  /// process the whole job.
  virtual absl::StatusOr<JobOutput> Assemble(const StageCall& call) = 0;
};

/// Cuts the jobs of one process into tasks: DESIGN section 1, "A process". Each process has one
/// derived class. All processes share the pipeline, dispatcher, cache, watches and cancellation.
class JobProcess {
 public:
  virtual ~JobProcess() = default;

  /// Returns the process that this class makes jobs of.
  virtual Process process() const = 0;

  /// Runs the stages that need the whole job. Errors: errors of these stages; NOTHING_TO_PRINT.
  virtual absl::StatusOr<std::unique_ptr<PlannedJob>> Plan(const StageCall& call,
                                                           JobInput input) const = 0;

  /// Returns true if Estimate needs the outlines of all layers. If false, the caller does not slice
  /// the meshes: `sliced` has no layers, and Estimate uses the meshes of `input`.
  virtual bool EstimatesByOutlines() const { return true; }

  /// Estimates time, filament and layers of the job from its outlines. Makes a few tasks for the
  /// estimate if the process supports it and `executor` has slots for it. Errors: errors of the
  /// stages that process the whole job.
  virtual absl::StatusOr<JobEstimate> Estimate(const StageCall& call, SlicedJob sliced,
                                               JobInput input, TaskExecutor& executor) const = 0;
};

}  // namespace slicefarm::coordinator
