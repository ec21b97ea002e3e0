#pragma once

#include <span>

#include "common/geometry/polygon.h"

namespace slicefarm {

/// An axis-parallel box; empty if min > max.
struct Box {
  Point min{INT64_MAX, INT64_MAX};
  Point max{INT64_MIN, INT64_MIN};

  bool Empty() const { return min.x > max.x || min.y > max.y; }
  /// Extends the box to contain p.
  void Add(Point p);
  /// Extends the box to contain another box.
  void Add(const Box& box);
  /// Returns true if the boxes have a common point.
  bool Intersects(const Box& other) const;
  /// Returns the box with all sides moved outwards by `by`.
  Box Grown(Coord by) const;

  friend bool operator==(const Box&, const Box&) = default;
};

/// Returns the smallest box around the points; empty if there are none.
Box Bounds(std::span<const Point> points);
/// Returns the smallest box around the islands; empty if there are none.
Box Bounds(const MultiPolygon& polygons);

/// Returns the area in nm^2, positive for counter-clockwise rings. The sum is exact and is rounded
/// once.
double SignedArea(const Polygon& ring);
/// Returns the area of an island without its holes, in nm^2.
double Area(const PolygonWithHoles& polygon);
/// Returns the area of all islands, in nm^2.
double Area(const MultiPolygon& polygons);

/// Returns the centre of mass of a ring, or the mean of its points if the area is zero. REQUIRES:
/// ring not empty.
Point Centroid(const Polygon& ring);

/// Returns the length in nm of an open line.
double Length(std::span<const Point> line);
/// Returns the length in nm of a ring, including its closing edge.
double Perimeter(const Polygon& ring);

/// Position of a point relative to a ring or island.
enum class Side { kOutside, kBoundary, kInside };

/// Returns the position of p relative to the ring; exact, by crossing number. Cost: O(n), n points.
Side Locate(Point p, const Polygon& ring);
/// Returns the position of p relative to an island. Points in a hole are outside.
Side Locate(Point p, const PolygonWithHoles& polygon);

/// Returns the point of the segment ab nearest to p, rounded to nm.
Point NearestOnSegment(Point p, Point a, Point b);

/// Returns the distance in nm from p to the segment ab.
double DistanceToSegment(Point p, Point a, Point b);

}  // namespace slicefarm
