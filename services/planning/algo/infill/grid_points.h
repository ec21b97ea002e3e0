#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// The points inside a region whose coordinates are multiples of `step_nm`, row by row. So points
/// of regions of one object are on the same grid. Cost: O(rows crossed by each edge + points).
std::vector<Point> GridPoints(const MultiPolygon& region, Coord step_nm);

}  // namespace slicefarm::planning
