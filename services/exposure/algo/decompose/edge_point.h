#pragma once

#include "common/geometry/point.h"

namespace slicefarm::exposure {

/// Point on an edge, or close to it.
struct EdgePoint {
  Point point;
  bool exact = true;  ///< true: exactly on the edge; false: less than 2 units to its left
};

/// Returns a point between a and b, near the middle of the range from `low` to `high`, which are
/// fractions of the edge. The fraction of the point is strictly inside this range. The point is
/// exactly on the edge if the range contains a point with integer coordinates.
///
/// Among the exact points, the one with the simplest fraction in halves and fifths is chosen. The
/// coordinate differences of both parts of the edge then still have common factors, so that the
/// parts can be divided again. REQUIRES: 0 <= low < high <= 1.
EdgePoint PointOnEdge(Point a, Point b, double low, double high);

}  // namespace slicefarm::exposure
