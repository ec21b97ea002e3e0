#pragma once

#include <memory>
#include <string>
#include <utility>

#include "common/stage/milling_stage.h"
#include "common/stage/slicing_stage.h"
#include "services/coordinator/algo/pipeline/job_process.h"

namespace slicefarm::coordinator {

/// Makes a milling program from meshes, in these steps:
///   1 placing   2 part and stock (mill_scene.h)   3 levels and rows   4 tasks (step_split.h)
///   5 assembly of the program
class MillProcess : public JobProcess {
 public:
  /// Creates a process. The stages must outlive it. `spool_directory`: directory for programs that
  /// wait (SpoolFile::Make).
  MillProcess(const PlacingStage& placing, const MillingStage& milling,
              std::string spool_directory = "")
      : placing_(placing), milling_(milling), spool_directory_(std::move(spool_directory)) {}

  /// Returns a process that uses these stages; null if a stage is missing.
  static std::unique_ptr<JobProcess> Over(const Stages& stages, const std::string& spool_directory);

  Process process() const override { return Process::kMill; }
  /// Plans the job. Errors: as in JobProcess, and any error of TakeStock and MillSceneOf.
  absl::StatusOr<std::unique_ptr<PlannedJob>> Plan(const StageCall& call,
                                                   JobInput input) const override;
  absl::StatusOr<JobEstimate> Estimate(const StageCall& call, SlicedJob sliced, JobInput input,
                                       TaskExecutor& executor) const override;

 private:
  const PlacingStage& placing_;
  const MillingStage& milling_;
  const std::string spool_directory_;
};

}  // namespace slicefarm::coordinator
