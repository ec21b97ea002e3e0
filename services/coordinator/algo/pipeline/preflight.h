#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/stage/stages.h"
#include "processes/fdm/job/fdm_process.h"
#include "processes/fdm/job/print_estimate.h"

namespace slicefarm::coordinator {

/// What can be told of a job before it is made.
struct Preflight {
  std::vector<MeshReport> meshes;
  int32_t layers = 0;  ///< of all copies, if they are printed one after the other
  double first_layer_area_mm2 = 0;
  PrintEstimate estimate;
  std::vector<OrientationAdvice> orientations;  ///< if the input asks for them
  std::vector<std::string> warnings;  ///< those of the settings, then what the meshes lack
};

/// Who makes single layers.
struct Sampling {
  const FdmProcess& fdm;
  TaskExecutor& executor;
};

/// Slices the meshes and looks at the outlines. With complete_objects it plans the job as well, to
/// see whether the copies have an order. With `sampling`, and runners there, jobs of FDM are
/// planned and a few of their layers made, which is what the estimate is then of; without, it is
/// of outlines alone. Errors: those of slicing, OUT_OF_BUILD_VOLUME among them; NOTHING_TO_PRINT;
/// those of planning, OBJECTS_COLLIDE among them; those of the stages that make layers.
absl::StatusOr<Preflight> LookAt(const StageCall& call, JobInput input, const SlicingStage& slicing,
                                 const PlanningStage& planning, const Sampling* sampling = nullptr);

}  // namespace slicefarm::coordinator
