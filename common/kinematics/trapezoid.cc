#include "common/kinematics/trapezoid.h"

#include <algorithm>
#include <cmath>

namespace slicefarm {

MoveProfile Trapezoid(const KinematicMove& move, double entry_v2, double cruise_v2,
                      double exit_v2) {
  const double a = move.acceleration_mm_s2;
  const double peak_v2 = (entry_v2 + exit_v2) / 2 + a * move.length_mm;
  cruise_v2 = std::max(std::min(cruise_v2, peak_v2), std::max(entry_v2, exit_v2));
  MoveProfile profile;
  profile.entry_mm_s = std::sqrt(entry_v2);
  profile.cruise_mm_s = std::sqrt(cruise_v2);
  profile.exit_mm_s = std::sqrt(exit_v2);
  const double ramps_mm = (2 * cruise_v2 - entry_v2 - exit_v2) / (2 * a);
  const double ramps_s = (2 * profile.cruise_mm_s - profile.entry_mm_s - profile.exit_mm_s) / a;
  profile.time_s = ramps_s + std::max(0.0, move.length_mm - ramps_mm) / profile.cruise_mm_s;
  return profile;
}

double RestToRest(double length_mm, double speed_mm_s, double acceleration_mm_s2) {
  if (length_mm <= 0) return 0;
  const KinematicMove move{length_mm, {1, 0, 0, 0}, speed_mm_s, acceleration_mm_s2};
  return Trapezoid(move, 0, speed_mm_s * speed_mm_s, 0).time_s;
}

}  // namespace slicefarm
