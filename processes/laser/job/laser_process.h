#pragma once

#include <memory>
#include <string>
#include <utility>

#include "common/stage/exposure_stage.h"
#include "common/stage/slicing_stage.h"
#include "services/coordinator/algo/pipeline/job_process.h"

namespace slicefarm::coordinator {

/// Meshes to a file of scan vectors:
///   1 slicing   2 ranges with halo (range_split.h)   3 tasks   4 frame and assembly
class LaserProcess : public JobProcess {
 public:
  /// The stages must outlive it. `spool_directory`: where programs wait for each other
  /// (SpoolFile::Make).
  LaserProcess(const SlicingStage& slicing, const ExposureStage& exposure,
               std::string spool_directory = "")
      : slicing_(slicing), exposure_(exposure), spool_directory_(std::move(spool_directory)) {}

  /// Null: a stage is missing.
  static std::unique_ptr<JobProcess> Over(const Stages& stages, const std::string& spool_directory);

  Process process() const override { return Process::kLaser; }
  /// Errors also: SETTING_OUT_OF_RANGE if the one layer that is asked for is not there.
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
