#include "common/kinematics/klipper_junction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace slicefarm {
namespace {

/// Default value of instantaneous_corner_velocity of Klipper's extruders.
constexpr double kExtruderCornerMmS = 1;
/// Acceleration of moves of only the extruder, before its own limits.
constexpr double kExtruderAloneMmS2 = 99'999'999.9;

void Limit(double& value, double limit) {
  if (limit > 0) value = std::min(value, limit);
}

/// Returns the greatest squared speed at a corner; infinite if the direction does not change.
double CornerV2(const KinematicMove& before, const KinematicMove& move) {
  const double turn_cos = before.ratio[kX] * move.ratio[kX] + before.ratio[kY] * move.ratio[kY] +
                          before.ratio[kZ] * move.ratio[kZ];
  const double sin_half = std::sqrt(std::max(0.0, (1 + turn_cos) / 2));
  const double cos_half = std::sqrt(std::max(0.0, (1 - turn_cos) / 2));
  if (sin_half >= 1 || cos_half == 0) return std::numeric_limits<double>::infinity();
  const double deviation_v2 =
      std::min(before.corner_v2, move.corner_v2) * sin_half / (1 - sin_half);
  const double path = std::min(before.length_mm * before.acceleration_mm_s2,
                               move.length_mm * move.acceleration_mm_s2);
  return std::min(deviation_v2, path * sin_half / cos_half / 2);
}

void LimitByExtruder(KinematicMove& move, const MachineLimits& limits) {
  const double share = std::abs(move.ratio[kE]);
  Limit(move.speed_mm_s, limits.max_feedrate_mm_s[kE] / share);
  Limit(move.acceleration_mm_s2, limits.max_acceleration_mm_s2[kE] / share);
  Limit(move.acceleration_mm_s2, limits.max_acceleration_retracting_mm_s2 / share);
}

void LimitByToolhead(KinematicMove& move, const MachineLimits& limits) {
  Limit(move.speed_mm_s, limits.max_feedrate_mm_s[kX]);
  Limit(move.speed_mm_s, limits.max_feedrate_mm_s[kY]);
  if (const double z = std::abs(move.ratio[kZ]); z > 0) {
    Limit(move.speed_mm_s, limits.max_feedrate_mm_s[kZ] / z);
    Limit(move.acceleration_mm_s2, limits.max_acceleration_mm_s2[kZ] / z);
  }
}

}  // namespace

KinematicMove LimitedByKlipper(KinematicMove move, const MachineLimits& limits) {
  const double asked = move.acceleration_mm_s2;
  if (move.ExtruderOnly()) {
    move.acceleration_mm_s2 = kExtruderAloneMmS2;
  } else {
    LimitByToolhead(move, limits);
  }
  if (const double e = move.ratio[kE]; e < 0 || (e > 0 && !move.InPlane()))
    LimitByExtruder(move, limits);
  // Square corner velocity is the speed at a right angle, independent of the requested
  // acceleration. If an axis limits the acceleration, it limits the squared corner speed by the
  // same factor.
  const double corner = limits.square_corner_velocity_mm_s;
  const double share = std::min(1.0, move.acceleration_mm_s2 / asked);
  move.corner_v2 = share * corner * corner * (std::numbers::sqrt2 - 1);
  return move;
}

double KlipperJunctionV2(const KinematicMove& before, const KinematicMove& move) {
  if (before.ExtruderOnly() || move.ExtruderOnly()) return 0;
  const double speed = std::min(before.speed_mm_s, move.speed_mm_s);
  double v2 = std::min(speed * speed, CornerV2(before, move));
  if (const double change = move.ratio[kE] - before.ratio[kE]; change != 0) {
    const double extruder = kExtruderCornerMmS / change;
    v2 = std::min(v2, extruder * extruder);
  }
  return v2;
}

}  // namespace slicefarm
