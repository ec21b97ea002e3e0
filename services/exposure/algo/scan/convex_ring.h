#pragma once

#include <vector>

#include "common/geometry/point.h"
#include "common/geometry/polygon.h"
#include "common/geometry/vector.h"

namespace slicefarm::exposure {

/// Corners of a convex polygon in nm, not yet rounded.
using ConvexRing = std::vector<Vector2>;

/// Converts a piece with coordinates in 1 / `scale` nm to a ring in nm.
inline ConvexRing ConvexRingOf(const Polygon& piece, double scale) {
  ConvexRing ring;
  for (const Point p : piece)
    ring.push_back({static_cast<double>(p.x) / scale, static_cast<double>(p.y) / scale});
  return ring;
}

}  // namespace slicefarm::exposure
