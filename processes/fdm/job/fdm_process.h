#pragma once

#include <memory>
#include <span>
#include <string>
#include <utility>

#include "common/stage/motion_stage.h"
#include "common/stage/planning_stage.h"
#include "common/stage/slicing_stage.h"
#include "processes/fdm/job/sampled_estimate.h"
#include "processes/fdm/model/fdm_settings.h"
#include "services/coordinator/algo/dispatch/task_executor.h"
#include "services/coordinator/algo/pipeline/job_process.h"

namespace slicefarm::coordinator {

/// A planned job: the input from which its layers are made.
struct PlannedPlate {
  SlicedJob sliced;
  JobPlan plan;
  FdmSettings settings;
  std::string settings_text;  ///< see JobInput
};

/// Makes G-code from meshes, in these steps:
///   1 slicing   2 planning   3 ranges with halo (range_split.h)   4 tasks   5 frame and assembly
class FdmProcess : public JobProcess {
 public:
  /// Creates a process. The stages must outlive it. `spool_directory`: directory for programs that
  /// wait for other programs (SpoolFile::Make).
  FdmProcess(const SlicingStage& slicing, const PlanningStage& planning, const MotionStage& motion,
             std::string spool_directory = "")
      : slicing_(slicing),
        planning_(planning),
        motion_(motion),
        spool_directory_(std::move(spool_directory)) {}

  /// Returns a process that uses these stages; null if a stage is missing.
  static std::unique_ptr<JobProcess> Over(const Stages& stages, const std::string& spool_directory);

  Process process() const override { return Process::kFdm; }
  absl::StatusOr<std::unique_ptr<PlannedJob>> Plan(const StageCall& call,
                                                   JobInput input) const override;
  /// Estimates a job. A plate is planned if its copies are printed one after another, or if layers
  /// are sampled.
  absl::StatusOr<JobEstimate> Estimate(const StageCall& call, SlicedJob sliced, JobInput input,
                                       TaskExecutor& executor) const override;

  /// Makes only the given layers and returns their times and filament. Errors: any error of the
  /// stages and of the executor.
  absl::StatusOr<LayerSamples> Sample(const StageCall& call, PlannedPlate plate,
                                      std::span<const int32_t> layers,
                                      TaskExecutor& executor) const;

 private:
  const SlicingStage& slicing_;
  const PlanningStage& planning_;
  const MotionStage& motion_;
  const std::string spool_directory_;
};

}  // namespace slicefarm::coordinator
