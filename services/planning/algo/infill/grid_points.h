#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// Returns the points inside a region with coordinates that are multiples of `step_nm`, row by row.
/// All regions of one object therefore share one grid. Cost: O(rows crossed by each edge + points).
std::vector<Point> GridPoints(const MultiPolygon& region, Coord step_nm);

}  // namespace slicefarm::planning
