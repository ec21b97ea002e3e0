#pragma once

#include "common/geometry/polygon.h"
#include "services/beading/algo/classic/constant_walls.h"

namespace slicefarm::beading {

/// How many more walls than `plan` says an island gets so that the walls above it rest on something:
/// one more for as long as more than 30 % of the outlines above lie over the 1.5 walls inside of
/// its innermost one. In slopes that are nearly flat this fills the shell where the outlines step
/// inwards.
/// Cost: O(n log n) where outlines above lie inside of the walls; O(n) where they are the island's.
/// Source: measured, PrusaSlicer 2.5 (its help says 70 % of the loop above).
int32_t ExtraWalls(const PolygonWithHoles& island, const MultiPolygon& above, const WallPlan& plan);

}  // namespace slicefarm::beading
