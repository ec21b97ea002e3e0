#pragma once

#include "common/geometry/polygon.h"
#include "services/beading/algo/classic/constant_walls.h"

namespace slicefarm::beading {

/// Returns the number of walls that an island needs in addition to `plan` to support the walls
/// above it. One wall is added as long as more than 30 % of the length of the outlines above is
/// over the strip inside the innermost wall. The strip is 1.5 walls wide. In nearly flat slopes
/// this fills the shell where the outlines step inwards.
///
/// Cost: O(n log n), n points, if outlines above are inside of the walls; O(n) if they are the
/// island's own. Source: measured, PrusaSlicer 2.5 (its help says 70 % of the loop above).
int32_t ExtraWalls(const PolygonWithHoles& island, const MultiPolygon& above, const WallPlan& plan);

}  // namespace slicefarm::beading
