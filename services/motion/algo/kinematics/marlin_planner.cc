#include "services/motion/algo/kinematics/marlin_planner.h"

#include "services/motion/algo/kinematics/marlin_junction.h"

namespace slicefarm::motion {
namespace {

double Squared(double v) { return v * v; }

}  // namespace

KinematicMove MarlinPlanner::Limited(const KinematicMove& move) const {
  return LimitedByMarlin(move, limits());
}

double MarlinPlanner::StartV2(const KinematicMove& first) const {
  return limits().junction_deviation_mm > 0 ? 0 : Squared(SafeSpeed(first, limits()));
}

double MarlinPlanner::JunctionV2(const KinematicMove& before, const KinematicMove& move) const {
  if (limits().junction_deviation_mm > 0) return JunctionDeviationV2(before, move, limits());
  return Squared(ClassicJerkSpeed(before, move, limits()));
}

double MarlinPlanner::RestV2() const { return Squared(kMarlinRestMmS); }

}  // namespace slicefarm::motion
