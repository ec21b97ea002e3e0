#include "common/kinematics/marlin_planner.h"

#include "common/kinematics/marlin_junction.h"

namespace slicefarm {
namespace {

double Squared(double v) { return v * v; }

double MarlinStartV2(const KinematicMove& first, const MachineLimits& limits) {
  return limits.junction_deviation_mm > 0 ? 0 : Squared(SafeSpeed(first, limits));
}

double JunctionV2(const KinematicMove& before, const KinematicMove& move,
                  const MachineLimits& limits) {
  if (limits.junction_deviation_mm > 0) return JunctionDeviationV2(before, move, limits);
  return Squared(ClassicJerkSpeed(before, move, limits));
}

}  // namespace

MarlinPlanner::MarlinPlanner(const MachineLimits& limits)
    : TwoPassPlanner({LimitedByMarlin, MarlinStartV2, JunctionV2, Squared(kMarlinRestMmS)},
                     limits) {}

}  // namespace slicefarm
