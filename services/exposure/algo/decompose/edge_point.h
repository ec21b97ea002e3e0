#pragma once

#include "common/geometry/point.h"

namespace slicefarm::exposure {

/// A point of an edge.
struct EdgePoint {
  Point point;
  bool exact = true;  ///< exactly on the edge; else less than 2 units to its left
};

/// A point between a and b whose share of the way lies strictly between `low` and `high`, near
/// their middle: exactly on the edge wherever integers allow.
///
/// Of the exact places the roundest is taken, in halves and fifths: the edge's parts then have
/// common factors left, so that they can be divided again. REQUIRES: 0 <= low < high <= 1.
EdgePoint PointOnEdge(Point a, Point b, double low, double high);

}  // namespace slicefarm::exposure
