#include "common/geometry/fast_boolean.h"

#include <algorithm>
#include <vector>

#include "common/geometry/arrangement.h"

namespace slicefarm {

std::optional<MultiPolygon> TryBoolean(const MultiPolygon& a, const MultiPolygon& b, Operation op) {
  std::vector<internal::GroupedRing> rings;
  const auto append = [&](const Polygon& ring, int group) {
    rings.push_back({ring, group});
    // What b takes away counts as minus one.
    if (op == Operation::kDifference && group == 1)
      std::reverse(rings.back().points.begin(), rings.back().points.end());
  };
  for (const auto* region : {&a, &b}) {
    for (const PolygonWithHoles& island : *region) {
      append(island.outer, region == &b);
      for (const Polygon& hole : island.holes) append(hole, region == &b);
    }
  }
  return internal::TryWindingRegion(rings, op == Operation::kIntersection ? 2 : 1);
}

}  // namespace slicefarm
