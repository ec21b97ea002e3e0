#pragma once

#include <algorithm>

#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"

namespace slicefarm {

/// Returns true if `p` is inside one of the islands, or on its boundary. Exact. Cost: O(n), n
/// points.
inline bool Covers(const MultiPolygon& polygons, Point p) {
  return std::ranges::any_of(polygons, [p](const PolygonWithHoles& island) {
    return Locate(p, island) != Side::kOutside;
  });
}

}  // namespace slicefarm
