#pragma once

#include <memory>
#include <string>
#include <utility>

#include "common/stage/slicing_stage.h"
#include "common/stage/texture_stage.h"
#include "services/coordinator/algo/pipeline/job_process.h"

namespace slicefarm::coordinator {

/// Makes toolpaths over a surface from the surface and a texture, in these steps:
///   1 meshes in double precision   2 map of the surface   3 layout of layers
///   4 tasks: ranges of layers   5 joined texts of the layers
/// The setting `texture` may name an object as the texture. The surface is the first object that is
/// not the texture.
class EngraveProcess : public JobProcess {
 public:
  /// Creates a process. The stages must outlive it. `spool_directory`: directory for texts that
  /// wait to be written (SpoolFile::Make).
  EngraveProcess(const PlacingStage& placing, const TextureStage& texture,
                 std::string spool_directory = "")
      : placing_(placing), texture_(texture), spool_directory_(std::move(spool_directory)) {}

  /// Returns a process that uses these stages; null if a stage is missing.
  static std::unique_ptr<JobProcess> Over(const Stages& stages, const std::string& spool_directory);

  Process process() const override { return Process::kEngrave; }
  /// Plans the job. Errors: as in JobProcess, and REQUEST_MALFORMED for objects that are neither
  /// surface nor texture.
  absl::StatusOr<std::unique_ptr<PlannedJob>> Plan(const StageCall& call,
                                                   JobInput input) const override;
  bool EstimatesByOutlines() const override { return false; }
  /// Estimates the time from a few layers that are made for this purpose. If no worker can make
  /// them, the estimate uses the area, the distance of lines and the number of layers, and assumes
  /// that every layer covers the whole surface.
  absl::StatusOr<JobEstimate> Estimate(const StageCall& call, SlicedJob sliced, JobInput input,
                                       TaskExecutor& executor) const override;

 private:
  const PlacingStage& placing_;
  const TextureStage& texture_;
  const std::string spool_directory_;
};

}  // namespace slicefarm::coordinator
