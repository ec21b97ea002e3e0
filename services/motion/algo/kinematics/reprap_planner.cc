#include "services/motion/algo/kinematics/reprap_planner.h"

#include "services/motion/algo/kinematics/reprap_junction.h"

namespace slicefarm::motion {

KinematicMove RepRapPlanner::Limited(const KinematicMove& move) const {
  return LimitedByRepRap(move, limits());
}

double RepRapPlanner::StartV2(const KinematicMove& /*first*/) const { return 0; }

double RepRapPlanner::JunctionV2(const KinematicMove& before, const KinematicMove& move) const {
  return RepRapJunctionV2(before, move, limits());
}

double RepRapPlanner::RestV2() const { return 0; }

}  // namespace slicefarm::motion
