#include "common/kinematics/marlin_junction.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/base/portable_math.h"
#include "common/kinematics/axis_limits.h"

namespace slicefarm {
namespace {

using MoveVector = std::array<double, 4>;

constexpr double kNearlyOne = 0.999999;
/// Length below which a move belongs to a curve: see JD_HANDLE_SMALL_SEGMENTS.
constexpr double kShortMoveMm = 1;
constexpr double kCos135 = -0.70710678118654752;
/// Share of the junction speed: if both moves have a greater safe speed, the safe speed replaces
/// the junction speed.
constexpr double kSafeSpeedShare = 0.99;

double Dot(const MoveVector& a, const MoveVector& b) {
  return a[kX] * b[kX] + a[kY] * b[kY] + a[kZ] * b[kZ] + a[kE] * b[kE];
}

MoveVector Scaled(const MoveVector& v, double by) {
  return {v[kX] * by, v[kY] * by, v[kZ] * by, v[kE] * by};
}

/// Returns the direction with length 1 over all four axes. Without e, `ratio` already has length 1.
MoveVector Direction(const KinematicMove& move) {
  if (move.ratio[kE] == 0) return move.ratio;
  return Scaled(move.ratio, 1 / std::sqrt(Dot(move.ratio, move.ratio)));
}

/// Returns the change of an axis' speed at a junction. If the axis reverses, it is the greater of
/// the two speeds.
double AxisJerk(double before, double after) {
  if (before > after) {
    return after > 0 || before < 0 ? before - after : std::max(before, -after);
  }
  return after < 0 || before > 0 ? after - before : std::max(-before, after);
}

}  // namespace

KinematicMove LimitedByMarlin(KinematicMove move, const MachineLimits& limits) {
  const double slowest =
      move.ratio[kE] != 0 ? limits.min_extruding_rate_mm_s : limits.min_travel_rate_mm_s;
  move.speed_mm_s = std::max(move.speed_mm_s, slowest);
  move.speed_mm_s = LimitedByAxes(move.speed_mm_s, move.ratio, limits.max_feedrate_mm_s);
  move.acceleration_mm_s2 =
      LimitedByAxes(move.acceleration_mm_s2, move.ratio, limits.max_acceleration_mm_s2);
  return move;
}

double JunctionDeviationV2(const KinematicMove& before, const KinematicMove& move,
                           const MachineLimits& limits) {
  const MoveVector in = Direction(before);
  const MoveVector out = Direction(move);
  const double inner_cos = std::max(-Dot(in, out), -kNearlyOne);
  if (inner_cos > kNearlyOne) return kMarlinRestMmS * kMarlinRestMmS;

  MoveVector change = {out[kX] - in[kX], out[kY] - in[kY], out[kZ] - in[kZ], out[kE] - in[kE]};
  const double size = std::sqrt(Dot(change, change));
  change = size > 0 ? Scaled(change, 1 / size) : out;
  const double a = LimitedByAxes(move.acceleration_mm_s2, change, limits.max_acceleration_mm_s2);

  const double sin_half = std::sqrt((1 - inner_cos) / 2);
  double v2 = a * limits.junction_deviation_mm * sin_half / (1 - sin_half);
  if (move.length_mm < kShortMoveMm && inner_cos < kCos135) {
    v2 = std::min(v2, move.length_mm * a / Acos(-inner_cos));
  }
  const double speed = std::min(before.speed_mm_s, move.speed_mm_s);
  return std::min(v2, speed * speed);
}

double SafeSpeed(const KinematicMove& move, const MachineLimits& limits) {
  return LimitedByAxes(move.speed_mm_s, move.ratio, limits.max_jerk_mm_s);
}

double ClassicJerkSpeed(const KinematicMove& before, const KinematicMove& move,
                        const MachineLimits& limits) {
  const double safe = SafeSpeed(move, limits);
  double speed = std::min(before.speed_mm_s, move.speed_mm_s);
  double factor = 1;
  for (size_t axis = 0; axis < 4; ++axis) {
    const double exit = before.ratio[axis] * speed * factor;
    const double entry = move.ratio[axis] * speed * factor;
    const double jerk = AxisJerk(exit, entry);
    if (limits.max_jerk_mm_s[axis] > 0 && jerk > limits.max_jerk_mm_s[axis]) {
      factor *= limits.max_jerk_mm_s[axis] / jerk;
    }
  }
  speed *= factor;
  // A stop and a new start by jerk alone may be faster than the junction.
  const double threshold = speed * kSafeSpeedShare;
  return SafeSpeed(before, limits) > threshold && safe > threshold ? safe : speed;
}

}  // namespace slicefarm
