#pragma once

#include <memory>
#include <string>
#include <utility>

#include "common/stage/slicing_stage.h"
#include "common/stage/texture_stage.h"
#include "services/coordinator/algo/pipeline/job_process.h"

namespace slicefarm::coordinator {

/// A surface and a texture to ways over the surface:
///   1 meshes as doubles   2 the map   3 layers laid out   4 tasks: ranges of layers   5 their
///   texts
/// The first object is the surface, or the only one but that which `texture` names.
class EngraveProcess : public JobProcess {
 public:
  /// The stages must outlive it. `spool_directory`: where texts wait (SpoolFile::Make).
  EngraveProcess(const PlacingStage& placing, const TextureStage& texture,
                 std::string spool_directory = "")
      : placing_(placing), texture_(texture), spool_directory_(std::move(spool_directory)) {}

  /// Null: a stage is missing.
  static std::unique_ptr<JobProcess> Over(const Stages& stages, const std::string& spool_directory);

  Process process() const override { return Process::kEngrave; }
  /// Errors also: REQUEST_MALFORMED for objects that are neither surface nor texture.
  absl::StatusOr<std::unique_ptr<PlannedJob>> Plan(const StageCall& call,
                                                   JobInput input) const override;
  bool EstimatesByOutlines() const override { return false; }
  /// By a few layers that are made; where nobody makes them, by area, distance of lines and layers,
  /// as if all of each layer were worked.
  absl::StatusOr<JobEstimate> Estimate(const StageCall& call, SlicedJob sliced, JobInput input,
                                       TaskExecutor& executor) const override;

 private:
  const PlacingStage& placing_;
  const TextureStage& texture_;
  const std::string spool_directory_;
};

}  // namespace slicefarm::coordinator
