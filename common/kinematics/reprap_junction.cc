#include "common/kinematics/reprap_junction.h"

#include <algorithm>
#include <cmath>

#include "common/kinematics/axis_limits.h"

namespace slicefarm {
namespace {

/// Higher than the acceleration of any axis: no limit.
constexpr double kUnlimitedMmS2 = 1e8;

bool PrintsWhileMoving(const KinematicMove& move) { return move.InPlane() && move.ratio[kE] > 0; }
bool PushesFilamentOnly(const KinematicMove& move) {
  return move.ratio[kE] != 0 && !PrintsWhileMoving(move);
}

bool Alike(const KinematicMove& a, const KinematicMove& b) {
  return PrintsWhileMoving(a) == PrintsWhileMoving(b) && a.InPlane() == b.InPlane() &&
         PushesFilamentOnly(a) == PushesFilamentOnly(b);
}

}  // namespace

KinematicMove LimitedByRepRap(KinematicMove move, const MachineLimits& limits) {
  const double asked = move.InPlane() ? move.acceleration_mm_s2 : kUnlimitedMmS2;
  move.speed_mm_s = LimitedByAxes(move.speed_mm_s, move.ratio, limits.max_feedrate_mm_s);
  move.acceleration_mm_s2 = LimitedByAxes(asked, move.ratio, limits.max_acceleration_mm_s2);
  return move;
}

double RepRapJunctionV2(const KinematicMove& before, const KinematicMove& move,
                        const MachineLimits& limits) {
  if (!Alike(before, move)) return 0;
  double speed = std::min(before.speed_mm_s, move.speed_mm_s);
  for (size_t axis = 0; axis < move.ratio.size(); ++axis) {
    const double change = std::abs(move.ratio[axis] - before.ratio[axis]);
    const double jerk = limits.max_jerk_mm_s[axis];
    if (jerk > 0 && change * speed > jerk) speed = jerk / change;
  }
  return speed * speed;
}

}  // namespace slicefarm
