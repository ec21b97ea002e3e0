#pragma once

#include <array>

#include "common/model/layers/layer.h"
#include "common/model/path.h"
#include "services/motion/algo/toolpath/toolpath.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// With which acceleration each kind of move runs, in mm/s^2, and what of it the G-code has to say.
///
/// As in PrusaSlicer, default_acceleration = 0 leaves accelerations to the firmware, whatever the
/// features' settings are; the machine limits then say what the firmware's are. Some firmwares keep
/// travels' acceleration apart from printing's; elsewhere a travel runs as the path before it,
/// unless travel_acceleration is set and switched to. Klipper has one for all moves: what a
/// retraction is asked for is what was set last. A wipe is a print or a travel, as the firmware has
/// it.
struct Accelerations {
  std::array<double, kFeatureCount> print = {};
  double travel = 0;   ///< 0: what was set last
  double short_travel = 0;  ///< of those too short for a retraction; 0: as the others
  double retract = 0;  ///< of the filament alone; 0: what was set last
  bool told = false;   ///< the G-code sets them
  bool told_travel = false;
  bool one = false;  ///< travels and prints set the same
  bool wipe_travels = false;

  double Print(Feature feature) const { return print[static_cast<size_t>(feature)]; }
  /// Of a travel, where `before` was set last.
  double Travel(double before) const { return travel > 0 ? travel : before; }
  double Wipe(double before) const { return wipe_travels ? Travel(before) : before; }
  double Retract(double before) const { return retract > 0 ? retract : before; }
};

Accelerations AccelerationsFor(const MotionOptions& options, Ground ground);

}  // namespace slicefarm::motion
