#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm {

// Convex polygons in the form of ConvexHull: counter-clockwise, the smallest point first, no three
// points on a line. A single point and a segment are also valid, with one or two points.

/// Returns the convex hull of points in any order; empty if there are no points. Exact. Cost: O(n
/// log n), n points.
Polygon ConvexHull(std::vector<Point> points);

/// Returns the set of all sums a + b for points a and b of two convex polygons (Minkowski sum);
/// empty if one polygon is empty. Exact. Cost: O(n + m), n and m corners.
Polygon ConvexSum(const Polygon& a, const Polygon& b);

/// Returns the convex polygon mirrored in the origin. Cost: O(n log n).
Polygon Negated(const Polygon& convex);

/// Returns a convex polygon that contains the disc of `radius_nm` >= 0 around the origin, and
/// touches the disc on the axes. Up to a radius of 10 mm, the polygon is at most 2 % wider than the
/// disc (0.12 mm for 6 mm); above, at most 0.5 %. For radius 0 the polygon is a point.
Polygon DiscCover(Coord radius_nm);

/// Returns true if p is inside a convex polygon and not on its boundary. Exact. REQUIRES:
/// coordinates below 2^62. Cost: O(log n).
bool StrictlyInside(Point p, const Polygon& convex);

/// Returns the distance in nm between two convex polygons: 0 if they have a common point, infinite
/// if one is empty. Cost: O(n + m), n and m corners.
double ConvexDistance(const Polygon& a, const Polygon& b);

}  // namespace slicefarm
