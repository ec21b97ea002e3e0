#pragma once

#include <memory>
#include <string>
#include <utility>

#include "common/stage/exposure_stage.h"
#include "common/stage/slicing_stage.h"
#include "services/coordinator/algo/pipeline/job_process.h"

namespace slicefarm::coordinator {

/// Makes a file of scan vectors from meshes, in these steps:
///   1 slicing   2 ranges with halo (range_split.h)   3 tasks   4 frame and assembly
class LaserProcess : public JobProcess {
 public:
  /// Creates a process. The stages must outlive it. `spool_directory`: directory for programs that
  /// wait for other programs (SpoolFile::Make).
  LaserProcess(const SlicingStage& slicing, const ExposureStage& exposure,
               std::string spool_directory = "")
      : slicing_(slicing), exposure_(exposure), spool_directory_(std::move(spool_directory)) {}

  /// Returns a process that uses these stages; null if a stage is missing.
  static std::unique_ptr<JobProcess> Over(const Stages& stages, const std::string& spool_directory);

  Process process() const override { return Process::kLaser; }
  /// Plans the job. Errors: as in JobProcess, and SETTING_OUT_OF_RANGE if the settings request a
  /// single layer that does not exist.
  absl::StatusOr<std::unique_ptr<PlannedJob>> Plan(const StageCall& call,
                                                   JobInput input) const override;
  absl::StatusOr<JobEstimate> Estimate(const StageCall& call, SlicedJob sliced, JobInput input,
                                       TaskExecutor& executor) const override;

 private:
  const SlicingStage& slicing_;
  const ExposureStage& exposure_;
  const std::string spool_directory_;
};

}  // namespace slicefarm::coordinator
