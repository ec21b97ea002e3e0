#pragma once

#include <memory>

#include "common/stage/planning_stage.h"
#include "common/stage/stages.h"

namespace slicefarm::planning {

/// The planning stage in this process: a JobPlanner over the layers. Stateless.
/// Errors: JobPlanner's; Cancelled, polled once a layer and at the end between what lies on the
/// plate.
std::unique_ptr<PlanningStage> MakeLocalPlanning();

}  // namespace slicefarm::planning
