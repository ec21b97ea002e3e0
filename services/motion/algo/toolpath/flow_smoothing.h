#pragma once

#include "services/motion/algo/toolpath/toolpath.h"

namespace slicefarm::motion {

/// Largest rise and fall of the flow per time, in mm^3/s^2; 0: no limit.
struct FlowSlopes {
  double rise_mm3_s2 = 0;
  double fall_mm3_s2 = 0;
  double piece_mm = 1;       ///< length of beads with one flow
  bool outer_walls = false;  ///< true: only outer walls and walls over air have limits
};

/// Slows down beads next to slower ones, so that the flow q rises and falls no faster than the
/// slopes: q^2 changes over a volume V by at most 2 slope V. Beads are cut into pieces of about
/// `piece_mm` where their speed changes. The path and its total filament do not change. Beads with
/// another move between them do not affect each other. `filament_mm2`: section of the filament.
/// Cost: O(length).
void SmoothFlow(const FlowSlopes& slopes, double filament_mm2, Toolpath& path);

}  // namespace slicefarm::motion
