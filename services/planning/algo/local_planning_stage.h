#pragma once

#include <memory>

#include "common/stage/planning_stage.h"
#include "common/stage/stages.h"

namespace slicefarm::planning {

/// Returns the planning stage that runs in this program: a JobPlanner over the layers. The stage
/// has no state. Errors: see JobPlanner. Cancelled is polled once per layer, and at the end for
/// each object in the planners.
std::unique_ptr<PlanningStage> MakeLocalPlanning();

}  // namespace slicefarm::planning
