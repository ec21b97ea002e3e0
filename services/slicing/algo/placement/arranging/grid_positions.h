#pragma once

#include <cstddef>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::slicing {

/// Returns up to `count` translations that put equal parts in rows and columns around the bed's
/// middle, with `distance_nm` between their boxes.
///
/// The result is the most nearly square block for all parts; its last row may be incomplete. If no
/// such block fits, as on a full or round bed, the result is the grid positions nearest to the
/// middle. The result has fewer than `count` translations if the grid has no more free positions.
///
/// Units: nm; translations are multiples of kPositionStep (free_positions.h). `kept_off`: convex
/// polygons; no translation may be strictly inside of them. REQUIRES: bed and hull are convex
/// (common/geometry/convex.h), and the bed has at least three points.
///
/// Cost: O(g b) for the g positions of the grid over the bed's box and b corners of the bed.
std::vector<Point> GridPositions(const Polygon& bed, const Polygon& hull, Coord distance_nm,
                                 size_t count, const std::vector<Polygon>& kept_off = {});

}  // namespace slicefarm::slicing
