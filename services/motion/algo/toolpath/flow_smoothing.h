#pragma once

#include "services/motion/algo/toolpath/toolpath.h"

namespace slicefarm::motion {

/// How fast the flow may change from bead to bead, in mm^3/s^2; 0: at once.
struct FlowSlopes {
  double rise_mm3_s2 = 0;
  double fall_mm3_s2 = 0;
};

/// Slows beads down next to slower ones, so that the flow rises and falls no faster than the slopes
/// say: q^2 changes over a volume V by at most 2 slope V. Beads are cut into pieces of about 1 mm
/// where their speed changes; places and filament stay what they are in sum. Where beads do not
/// follow on each other, nothing is smoothed. `filament_mm2`: its section. Cost: O(length).
void SmoothFlow(const FlowSlopes& slopes, double filament_mm2, Toolpath& path);

}  // namespace slicefarm::motion
