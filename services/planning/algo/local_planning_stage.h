#pragma once

#include <memory>

#include "common/stage/planning_stage.h"
#include "common/stage/stages.h"

namespace slicefarm::planning {

/// Returns the planning stage in this program: a JobPlanner over the layers. The stage is
/// stateless. Errors: as JobPlanner; Cancelled, polled once per layer, and at the end between the
/// planners' objects.
std::unique_ptr<PlanningStage> MakeLocalPlanning();

}  // namespace slicefarm::planning
