#include "services/motion/algo/kinematics/klipper_junction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace slicefarm::motion {
namespace {

/// The default of instantaneous_corner_velocity of Klipper's extruders.
constexpr double kExtruderCornerMmS = 1;

void Limit(double& value, double limit) {
  if (limit > 0) value = std::min(value, limit);
}

/// Infinite where the direction stays.
double CornerV2(const KinematicMove& before, const KinematicMove& move, double corner_v2) {
  const double turn_cos = before.ratio[kX] * move.ratio[kX] + before.ratio[kY] * move.ratio[kY] +
                          before.ratio[kZ] * move.ratio[kZ];
  const double sin_half = std::sqrt(std::max(0.0, (1 + turn_cos) / 2));
  const double cos_half = std::sqrt(std::max(0.0, (1 - turn_cos) / 2));
  if (sin_half >= 1 || cos_half == 0) return std::numeric_limits<double>::infinity();
  // Square corner velocity is the speed at a right angle whatever the acceleration asked for; what
  // the z axis takes from the acceleration, it takes from the corner.
  const double deviation_v2 = std::min(before.acceleration_share, move.acceleration_share) *
                              corner_v2 * (std::numbers::sqrt2 - 1) * sin_half / (1 - sin_half);
  const double way = std::min(before.length_mm * before.acceleration_mm_s2,
                              move.length_mm * move.acceleration_mm_s2);
  return std::min(deviation_v2, way * sin_half / cos_half / 2);
}

}  // namespace

KinematicMove LimitedByKlipper(KinematicMove move, const MachineLimits& limits) {
  if (move.ExtruderOnly()) {
    Limit(move.speed_mm_s, limits.max_feedrate_mm_s[kE]);
    double acceleration = std::numeric_limits<double>::infinity();
    Limit(acceleration, limits.max_acceleration_mm_s2[kE]);
    Limit(acceleration, limits.max_acceleration_retracting_mm_s2);
    if (std::isfinite(acceleration)) move.acceleration_mm_s2 = acceleration;
    return move;
  }
  Limit(move.speed_mm_s, limits.max_feedrate_mm_s[kX]);
  Limit(move.speed_mm_s, limits.max_feedrate_mm_s[kY]);
  if (const double z = std::abs(move.ratio[kZ]); z > 0) {
    Limit(move.speed_mm_s, limits.max_feedrate_mm_s[kZ] / z);
    const double asked = move.acceleration_mm_s2;
    Limit(move.acceleration_mm_s2, limits.max_acceleration_mm_s2[kZ] / z);
    move.acceleration_share = move.acceleration_mm_s2 / asked;
  }
  return move;
}

double KlipperJunctionV2(const KinematicMove& before, const KinematicMove& move,
                         const MachineLimits& limits) {
  if (before.ExtruderOnly() || move.ExtruderOnly()) return 0;
  const double speed = std::min(before.speed_mm_s, move.speed_mm_s);
  double v2 = speed * speed;
  const double corner = limits.square_corner_velocity_mm_s;
  v2 = std::min(v2, CornerV2(before, move, corner * corner));
  if (const double change = move.ratio[kE] - before.ratio[kE]; change != 0) {
    const double extruder = kExtruderCornerMmS / change;
    v2 = std::min(v2, extruder * extruder);
  }
  return v2;
}

}  // namespace slicefarm::motion
