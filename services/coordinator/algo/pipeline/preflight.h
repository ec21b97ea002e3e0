#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/stage/stages.h"
#include "services/coordinator/algo/pipeline/job_pipeline.h"

namespace slicefarm::coordinator {

/// Facts and estimates about a job before it is made.
struct Preflight {
  std::vector<MeshReport> meshes;
  /// Number of layers; if the copies are printed one after the other, summed over the copies.
  int32_t layers = 0;
  double first_layer_area_mm2 = 0;
  double print_time_s = 0;
  FilamentUse filament;
  /// Advice on orientations, if the input requests it.
  std::vector<OrientationAdvice> orientations;
  std::vector<std::string> warnings;  ///< warnings of the settings, then defects of the meshes
};

/// Estimates the time and material of a job. If the job's process estimates by outlines, slices the
/// meshes first. The process may make some of the job's tasks for the estimate. Errors:
/// NOTHING_TO_PRINT; PROCESS_UNAVAILABLE; errors of the stages slicing (such as
/// OUT_OF_BUILD_VOLUME) and planning (such as OBJECTS_COLLIDE), and of the stages that make layers.
absl::StatusOr<Preflight> LookAt(const StageCall& call, JobInput input, const SlicingStage& slicing,
                                 const JobPipeline& pipeline);

}  // namespace slicefarm::coordinator
