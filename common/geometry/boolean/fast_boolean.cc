#include "common/geometry/boolean/fast_boolean.h"

#include <algorithm>
#include <vector>

#include "common/geometry/boolean/arrangement.h"

namespace slicefarm {

std::optional<MultiPolygon> TryBoolean(const MultiPolygon& a, const MultiPolygon& b, Operation op) {
  std::vector<internal::GroupedRing> rings;
  ForEachRing(a, [&](const Polygon& ring) { rings.push_back({ring, 0}); });
  ForEachRing(b, [&](const Polygon& ring) {
    std::vector<Point>& points = rings.emplace_back(internal::GroupedRing{ring, 1}).points;
    // A difference subtracts b, so the rings of b count as -1.
    if (op == Operation::kDifference) std::reverse(points.begin(), points.end());
  });
  return internal::TryWindingRegion(rings, op == Operation::kIntersection ? 2 : 1);
}

}  // namespace slicefarm
