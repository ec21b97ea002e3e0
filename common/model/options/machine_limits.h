#pragma once

#include <array>
#include <cstdint>

namespace slicefarm {

/// Firmware for which the G-code is written.
enum class GcodeFlavor { kMarlin2, kMarlinLegacy, kKlipper, kRepRapFirmware, kPrusaBuddy, kBambu };

/// Limits that are set in the machine's firmware. The motion planner (common/kinematics) uses the
/// same rules, so that times are accurate.
struct MachineLimits {
  // Values in the order x, y, z, e.
  /// Setting machine_max_feedrate_x..e.
  std::array<double, 4> max_feedrate_mm_s = {300, 300, 20, 120};
  /// Setting machine_max_acceleration_x..e.
  std::array<double, 4> max_acceleration_mm_s2 = {3000, 3000, 500, 3000};
  /// Setting machine_max_jerk_x..e (classic jerk).
  std::array<double, 4> max_jerk_mm_s = {8, 8, 0.4, 2.5};
  /// Setting machine_max_acceleration_extruding.
  double max_acceleration_extruding_mm_s2 = 1500;
  /// Setting machine_max_acceleration_retracting.
  double max_acceleration_retracting_mm_s2 = 1500;
  /// Setting machine_max_acceleration_travel.
  double max_acceleration_travel_mm_s2 = 3000;
  /// Setting machine_max_junction_deviation; 0: classic jerk is used.
  double junction_deviation_mm = 0;
  double square_corner_velocity_mm_s = 5;  ///< setting square_corner_velocity (Klipper)
  double minimum_cruise_ratio = 0.5;       ///< setting minimum_cruise_ratio (Klipper)
  double min_extruding_rate_mm_s = 0;      ///< `machine_min_extruding_rate`: lowest speed of beads
  double min_travel_rate_mm_s = 0;         ///< `machine_min_travel_rate`: lowest speed of travels
  /// `jerk_limit`: largest change of acceleration per time (JerkPlanner)
  double jerk_mm_s3 = 100'000;
  /// true if the G-code sets these limits: `machine_limits_usage = emit_to_gcode`
  bool emit_to_gcode = false;

  friend bool operator==(const MachineLimits&, const MachineLimits&) = default;
};

}  // namespace slicefarm
