#pragma once

#include <algorithm>
#include <iterator>

#include "common/geometry/polygon.h"

namespace slicefarm::internal {

/// Adds up what `one` makes of each island on its own, in canonical form. A sweep's cost grows with
/// all edges that a scan line meets, so many small sweeps beat one over a whole layer. REQUIRES:
/// the results of islands that do not meet do not meet either.
template <typename One>
MultiPolygon ByIsland(const MultiPolygon& polygons, const One& one) {
  if (polygons.size() == 1) return one(polygons);
  MultiPolygon all;
  for (const PolygonWithHoles& island : polygons) {
    MultiPolygon part = one({island});
    std::move(part.begin(), part.end(), std::back_inserter(all));
  }
  Canonicalize(all);
  return all;
}

}  // namespace slicefarm::internal
