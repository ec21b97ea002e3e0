#pragma once

#include <algorithm>
#include <iterator>

#include "common/geometry/polygon.h"

namespace slicefarm::internal {

/// Applies `one` to each island separately and returns all results in canonical form. The cost of
/// one sweep grows with the number of edges that meet a scan line, so many small sweeps are faster
/// than one sweep over a whole layer. REQUIRES: if two islands do not meet, their results do not
/// meet either.
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
