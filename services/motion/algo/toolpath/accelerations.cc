#include "services/motion/algo/toolpath/accelerations.h"

#include <algorithm>

#include "common/model/options/motion_options.h"
#include "services/motion/algo/firmware/firmware.h"
namespace slicefarm::motion {
namespace {

/// Acceleration without settings and machine limits.
constexpr double kDefaultMmS2 = 1000;

double FirstSet(std::initializer_list<double> values) {
  for (const double value : values) {
    if (value > 0) return value;
  }
  return kDefaultMmS2;
}

/// Returns an acceleration within a limit of the machine, if the G-code sets this limit. A limit of
/// 0 is none.
double Within(const MachineLimits& limits, double limit_mm_s2, double asked_mm_s2) {
  const bool limited = limits.emit_to_gcode && limit_mm_s2 > 0;
  return limited ? std::min(asked_mm_s2, limit_mm_s2) : asked_mm_s2;
}

/// Returns true if the firmware treats a wipe as a travel: a move in the plane that retracts
/// filament.
bool WipesAreTravels(const Firmware& firmware) {
  MachineLimits limits;
  limits.max_acceleration_extruding_mm_s2 = 1;
  limits.max_acceleration_travel_mm_s2 = 2;
  return firmware.AccelerationFor({.length_mm = 1, .ratio = {1, 0, 0, -0.1}}, limits) == 2;
}

}  // namespace

Accelerations AccelerationsFor(const MotionOptions& options, Ground ground) {
  const MachineLimits& limits = options.limits;
  const Firmware& firmware = FirmwareOf(options.flavor);
  Accelerations result;
  result.written = options.default_acceleration_mm_s2 > 0;
  result.travel_written = result.written && options.travel_acceleration_mm_s2 > 0;
  for (size_t i = 0; i < result.print.size(); ++i) {
    double asked = limits.max_acceleration_extruding_mm_s2;
    if (result.written) {
      asked = FirstSet({options.acceleration_mm_s2[i], options.default_acceleration_mm_s2});
      const double of_ground = ground == Ground::kBed    ? options.first_layer_acceleration_mm_s2
                               : ground == Ground::kRaft ? options.over_raft_acceleration_mm_s2
                                                         : 0;
      if (of_ground > 0) asked = of_ground;
      asked = Within(limits, limits.max_acceleration_extruding_mm_s2, asked);
    }
    result.print[i] = FirstSet({asked});
  }
  if (result.travel_written) {
    result.travel = options.travel_acceleration_mm_s2;
    if (ground == Ground::kBed && options.first_layer_travel_acceleration_mm_s2 > 0)
      result.travel = options.first_layer_travel_acceleration_mm_s2;
    result.short_travel = options.short_travel_acceleration_mm_s2;
    if (firmware.HasTravelAcceleration())
      for (double* travel : {&result.travel, &result.short_travel})
        *travel = Within(limits, limits.max_acceleration_travel_mm_s2, *travel);
  } else if (firmware.HasTravelAcceleration()) {
    result.travel = limits.max_acceleration_travel_mm_s2;
  }
  if (firmware.HasRetractAcceleration())
    result.retract = FirstSet({limits.max_acceleration_retracting_mm_s2});
  result.one = !firmware.HasTravelAcceleration();
  result.wipe_travels = WipesAreTravels(firmware);
  if (options.flavor == GcodeFlavor::kKlipper) result.to_decel = options.accel_to_decel;
  result.jerks = JerksFor(options, ground);
  return result;
}

}  // namespace slicefarm::motion
