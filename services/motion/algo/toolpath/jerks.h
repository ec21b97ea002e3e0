#pragma once

#include <array>

#include "common/model/path.h"
#include "services/motion/algo/toolpath/toolpath.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// Jerk in x and y of each kind of move, in mm/s. `written` decides if the G-code sets them.
///
/// As in OrcaSlicer, default_jerk = 0 leaves the jerk to the firmware, even if features have
/// settings. All values are limited by the machine's jerk of x and of y.
struct Jerks {
  std::array<double, kFeatureCount> print = {};
  double travel = 0;  ///< 0: the jerk set last
  double z = 0;       ///< the machine's jerk in z
  double e = 0;       ///< the machine's jerk of the filament
  bool written = false;

  double Print(Feature feature) const { return print[static_cast<size_t>(feature)]; }
  /// Returns the jerk of a travel. `before`: jerk that was set last.
  double Travel(double before) const { return travel > 0 ? travel : before; }
  /// Returns the jerk of all axes.
  std::array<double, 4> OfAxes(double xy) const { return {xy, xy, z, e}; }
};

/// Returns the jerks of moves on `ground`.
Jerks JerksFor(const MotionOptions& options, Ground ground);

}  // namespace slicefarm::motion
