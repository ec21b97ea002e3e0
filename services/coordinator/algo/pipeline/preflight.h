#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/stage/stages.h"
#include "services/coordinator/algo/pipeline/job_pipeline.h"

namespace slicefarm::coordinator {

/// What can be told of a job before it is made.
struct Preflight {
  std::vector<MeshReport> meshes;
  int32_t layers = 0;  ///< of all copies, if they are printed one after the other
  double first_layer_area_mm2 = 0;
  double print_time_s = 0;
  FilamentUse filament;
  std::vector<OrientationAdvice> orientations;  ///< if the input asks for them
  std::vector<std::string> warnings;  ///< those of the settings, then what the meshes lack
};

/// Slices the meshes and looks at the outlines, if the job's process asks for them; it estimates
/// what the job will take, and may make some of its tasks to see. Errors: those of slicing,
/// OUT_OF_BUILD_VOLUME among them; NOTHING_TO_PRINT; those of planning, OBJECTS_COLLIDE among them;
/// those of the stages that make layers; PROCESS_UNAVAILABLE.
absl::StatusOr<Preflight> LookAt(const StageCall& call, JobInput input, const SlicingStage& slicing,
                                 const JobPipeline& pipeline);

}  // namespace slicefarm::coordinator
