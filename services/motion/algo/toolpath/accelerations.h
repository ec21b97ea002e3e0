#pragma once

#include <array>

#include "common/model/motion_options.h"
#include "common/model/path.h"

namespace slicefarm::motion {

/// With which acceleration each kind of move runs, in mm/s^2, and what of it the G-code has to say.
///
/// As in PrusaSlicer, default_acceleration = 0 leaves accelerations to the firmware, whatever the
/// features' settings are; the machine limits then say what the firmware's are. Only Marlin 2 keeps
/// travels' acceleration apart from printing's; elsewhere a travel runs as the path before it,
/// unless travel_acceleration is set and switched to.
struct Accelerations {
  std::array<double, kFeatureCount> print = {};
  double travel = 0;   ///< 0: that of the path before
  double retract = 0;  ///< of the filament alone
  bool told = false;   ///< the G-code sets them
  bool told_travel = false;

  double Print(Feature feature) const { return print[static_cast<size_t>(feature)]; }
  /// Of a travel, where the path before it runs with `before`.
  double Travel(double before) const { return travel > 0 ? travel : before; }
};

Accelerations AccelerationsFor(const MotionOptions& options, int32_t layer_index);

}  // namespace slicefarm::motion
