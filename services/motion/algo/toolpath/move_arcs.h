#pragma once

#include "services/motion/algo/toolpath/toolpath.h"

namespace slicefarm::motion {

/// Finds the beads that are printed as arcs (arc_fit.h): sequences of moves with the same width,
/// height, speed and feature. Sets `path.arcs`. Call this after all other changes of the moves. If
/// speeds change later, all moves of an arc must get the same speed. Cost: as FitArcs.
void FindArcs(Toolpath& path);

}  // namespace slicefarm::motion
