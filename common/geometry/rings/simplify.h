#pragma once

#include "common/geometry/polygon.h"

namespace slicefarm {

/// Removes points so that no point of the input is farther than `tolerance_nm` from the line that
/// replaces it (Douglas-Peucker). The ends remain. Cost: typically O(n log n), at worst O(n^2).
Polyline SimplifyLine(const Polyline& line, Coord tolerance_nm);

/// Simplifies a ring in the same manner. The ring is cut at two distant points, so that the result
/// does not depend on its start. Rings with fewer than three points or zero area afterwards are
/// returned empty.
Polygon SimplifyRing(const Polygon& ring, Coord tolerance_nm);

/// Simplifies each ring. Empty rings are removed; an island without an outer ring is removed with
/// its holes. Afterwards rings may touch or cross by up to the tolerance; use Union if this
/// matters.
MultiPolygon Simplify(const MultiPolygon& polygons, Coord tolerance_nm);

}  // namespace slicefarm
