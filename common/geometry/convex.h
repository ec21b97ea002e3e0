#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm {

/// Convex polygons as ConvexHull makes them: counter-clockwise, the least point first, no three
/// points on a line. A point or a segment counts as one, with one or two points.

/// The convex hull of points in any order; empty for none. Exact. Cost: O(n log n).
Polygon ConvexHull(std::vector<Point> points);

/// The set of all a + b, for points of convex polygons; empty if one is. Exact. Cost: O(n + m).
Polygon ConvexSum(const Polygon& a, const Polygon& b);

/// The convex polygon mirrored in the origin. Cost: O(n log n).
Polygon Negated(const Polygon& convex);

/// A convex polygon around the disc of `radius_nm` >= 0 about the origin, which contains it and
/// touches its axes: at most 2 % wider (0.12 mm of 6), 0.5 % above 10 mm. A point for radius 0.
Polygon DiscCover(Coord radius_nm);

/// Whether p lies within a convex polygon and not on its boundary. Exact. REQUIRES: coordinates
/// below 2^62. Cost: O(log n).
bool StrictlyInside(Point p, const Polygon& convex);

/// The distance in nm between two convex polygons, 0 if they have a point in common, infinite if
/// one is empty. Cost: O(n + m).
double ConvexDistance(const Polygon& a, const Polygon& b);

}  // namespace slicefarm
