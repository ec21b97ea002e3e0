#pragma once

#include "common/geometry/polygon.h"

namespace slicefarm {

/// Returns a lower bound of the area within `distance_nm` of an island, if the growth does not
/// overlap itself: neither across a gap nor in a hole. The bound is almost sharp. It can be
/// negative at spikes between two edges. Cost: O(n), n points.
double LeastGrownArea(const PolygonWithHoles& island, Coord distance_nm);

}  // namespace slicefarm
