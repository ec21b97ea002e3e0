#pragma once

#include "common/geometry/polygon.h"
#include "services/beading/algo/classic/constant_walls.h"

namespace slicefarm::beading {

/// Returns the number of walls that an island needs in addition to `plan`, so that the walls of the
/// layer above are supported. `above`: outlines of the layer above. A wall is added as long as more
/// than 30 % of the length of these outlines is over the strip inside the innermost wall. The strip
/// is 1.5 wall spacings wide. In nearly flat slopes this fills the shell where the outlines step
/// inwards.
///
/// Cost: O(n log n), n points, if parts of `above` are inside the walls; O(n) if `above` equals the
/// island. Source: measured, PrusaSlicer 2.5 (its help says 70 % of the loop above).
int32_t ExtraWalls(const PolygonWithHoles& island, const MultiPolygon& above, const WallPlan& plan);

}  // namespace slicefarm::beading
