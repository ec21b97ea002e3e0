#pragma once

#include <array>

#include "common/model/layers/layer.h"
#include "common/model/path.h"
#include "services/motion/algo/toolpath/jerks.h"
#include "services/motion/algo/toolpath/toolpath.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// Acceleration and jerk of each kind of move, in mm/s^2 and mm/s. `written` decides if the G-code
/// sets them.
///
/// As in PrusaSlicer, default_acceleration = 0 leaves accelerations to the firmware, even if
/// features have settings. The values are then the machine limits, which the firmware uses.
/// `written`: true if the G-code sets the accelerations.
///
/// Some firmwares have a separate acceleration for travels. With other firmwares a travel has the
/// acceleration of the path before it, unless travel_acceleration is set. Klipper has one
/// acceleration for all moves, so a retraction uses the one set last. The firmware decides whether
/// a wipe counts as a print or as a travel.
struct Accelerations {
  std::array<double, kFeatureCount> print = {};
  double travel = 0;  ///< 0: the acceleration set last
  /// for travels to outer walls that are too short for a retraction; 0: as other travels
  double short_travel = 0;
  double retract = 0;  ///< for moves in which only the filament moves; 0: the acceleration set last
  bool written = false;  ///< true if the G-code sets accelerations
  bool travel_written = false;
  bool one = false;  ///< true if travels and prints share one value in the machine
  bool wipe_travels = false;
  /// acceleration of short moves, which do not cruise, relative to `print`; 0: not set (Klipper)
  double to_decel = 0;
  Jerks jerks;

  double Print(Feature feature) const { return print[static_cast<size_t>(feature)]; }
  /// Returns the acceleration of a travel. `before`: acceleration that was set last.
  double Travel(double before) const { return travel > 0 ? travel : before; }
  double Wipe(double before) const { return wipe_travels ? Travel(before) : before; }
  double Retract(double before) const { return retract > 0 ? retract : before; }
};

/// Returns the accelerations for beads that are printed on `ground`.
Accelerations AccelerationsFor(const MotionOptions& options, Ground ground);

}  // namespace slicefarm::motion
