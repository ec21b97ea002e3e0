#pragma once

#include "common/geometry/polygon.h"

namespace slicefarm {

/// Drops points so that no point of the input lies farther than `tolerance_nm` from the line that
/// replaces it (Douglas-Peucker). Ends stay. Cost: O(n log n) as a rule, O(n^2) at worst.
Polyline SimplifyLine(const Polyline& line, Coord tolerance_nm);

/// The same for a ring; it is cut at two far points, so that the result does not depend on where
/// the ring starts. Rings that fall below three points or to zero area come back empty.
Polygon SimplifyRing(const Polygon& ring, Coord tolerance_nm);

/// Simplifies each ring; empty ones are dropped, an island whose outer ring goes takes its holes
/// with it. Rings may touch or cross by up to the tolerance afterwards: run Union where that
/// matters.
MultiPolygon Simplify(const MultiPolygon& polygons, Coord tolerance_nm);

}  // namespace slicefarm
