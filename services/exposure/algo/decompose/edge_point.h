#pragma once

#include "common/geometry/point.h"

namespace slicefarm::exposure {

/// Point of an edge.
struct EdgePoint {
  Point point;
  bool exact = true;  ///< true: exactly on the edge; false: less than 2 units to its left
};

/// Returns a point between a and b at a share strictly between `low` and `high`, near their middle.
/// The point is exactly on the edge wherever integers allow.
///
/// Among the exact points, the one with the simplest share in halves and fifths is chosen. The
/// parts of the edge then still have common factors, so that they can be divided again. REQUIRES: 0
/// <= low < high <= 1.
EdgePoint PointOnEdge(Point a, Point b, double low, double high);

}  // namespace slicefarm::exposure
