#pragma once

#include <cstddef>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::slicing {

/// Up to `count` translations that put equal parts in rows and columns around the bed's middle,
/// `distance_nm` between their boxes: the most nearly square block that holds all of them, its last
/// row perhaps not full; where no such block fits, as on a full or round bed, the places of the
/// grid that lie nearest to the middle. Fewer than `count`: this bed's grid holds no more.
///
/// Units:    nm; translations are multiples of kPlaceStep (free_places.h).
/// REQUIRES: bed and hull convex (common/geometry/convex.h), bed of at least three points.
/// Cost:     O(g b) for the g places of the grid over the bed's box and b corners of the bed.
/// `kept_off`: convex polygons, strictly inside of which no translation may lie.
std::vector<Point> GridPlaces(const Polygon& bed, const Polygon& hull, Coord distance_nm,
                              size_t count, const std::vector<Polygon>& kept_off = {});

}  // namespace slicefarm::slicing
