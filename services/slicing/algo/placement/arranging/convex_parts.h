#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::slicing {

/// A footprint as convex pieces whose union contains it, for packing.
///
/// A simple outline (in either direction) of few corners is cut exactly, by ear clipping and then
/// dropping cuts while the pieces stay convex (Hertel and Mehlhorn: at most four times the least
/// number). One of more corners is simplified outwards first, by up to 0.2 mm. What crosses itself,
/// has no area, or would need more than 12 pieces, comes as its convex hull.
///
/// Errors: none; no points give no pieces. Cost: O(n log n) and O(c^2) for the at most 200 corners
/// c that are cut.
std::vector<Polygon> ConvexParts(const Polygon& footprint);

}  // namespace slicefarm::slicing
