#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::slicing {

/// Returns convex pieces that together contain a footprint, for packing.
///
/// A simple outline (in either direction) with few corners is cut exactly: by ear clipping, then by
/// removing cuts while the pieces stay convex (Hertel and Mehlhorn: at most four times the smallest
/// possible number of pieces). An outline with more corners is first simplified outwards by up to
/// 0.2 mm. An outline that crosses itself, has no area, or would need more than 12 pieces gives its
/// convex hull.
///
/// Errors: none; an outline without points gives no pieces. Cost: O(n log n) for n corners, plus
/// O(c^2) for the c corners that are cut, at most 200.
std::vector<Polygon> ConvexParts(const Polygon& footprint);

}  // namespace slicefarm::slicing
