#pragma once

#include "common/geometry/polygon.h"

namespace slicefarm {

/// Removes points so that no point of the input is farther than `tolerance_nm` from the segment
/// that replaces it (Douglas-Peucker). The ends remain. Cost: typically O(n log n), at worst
/// O(n^2), n points.
Polyline SimplifyLine(const Polyline& line, Coord tolerance_nm);

/// Simplifies a ring like SimplifyLine. The ring is cut at two distant points, so that the result
/// does not depend on its start. If the result has fewer than three points or zero area, it is
/// returned empty.
Polygon SimplifyRing(const Polygon& ring, Coord tolerance_nm);

/// Simplifies each ring. Rings that become empty are removed; if an outer ring becomes empty, its
/// holes are removed too. Afterwards rings may touch or cross by up to the tolerance; use Union if
/// this matters.
MultiPolygon Simplify(const MultiPolygon& polygons, Coord tolerance_nm);

}  // namespace slicefarm
