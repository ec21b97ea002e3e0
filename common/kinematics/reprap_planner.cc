#include "common/kinematics/reprap_planner.h"

#include "common/kinematics/reprap_junction.h"

namespace slicefarm {
namespace {

double RepRapStartV2(const KinematicMove& /*first*/, const MachineLimits& /*limits*/) { return 0; }

}  // namespace

RepRapPlanner::RepRapPlanner(const MachineLimits& limits)
    : TwoPassPlanner({LimitedByRepRap, RepRapStartV2, RepRapJunctionV2, 0}, limits) {}

}  // namespace slicefarm
