#pragma once

#include <algorithm>
#include <iterator>

#include "common/geometry/polygon.h"

namespace slicefarm::internal {

/// Calls `one` for each island separately and returns all results in canonical form. The cost of a
/// sweep grows with the number of edges that meet the sweep line, so many small sweeps are faster
/// than one sweep over a whole layer. REQUIRES: the results of two islands do not meet each other.
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
