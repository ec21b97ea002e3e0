#pragma once

#include <span>

#include "common/geometry/polygon.h"

namespace slicefarm {

/// An axis-parallel box; empty if min > max.
struct Box {
  Point min{INT64_MAX, INT64_MAX};
  Point max{INT64_MIN, INT64_MIN};

  bool Empty() const { return min.x > max.x || min.y > max.y; }
  void Add(Point p);
  void Add(const Box& box);
  bool Intersects(const Box& other) const;
  Box Grown(Coord by) const;

  friend bool operator==(const Box&, const Box&) = default;
};

Box Bounds(std::span<const Point> points);
Box Bounds(const MultiPolygon& polygons);

/// Returns the area in nm^2, positive for counter-clockwise rings. It is summed exactly and rounded
/// once.
double SignedArea(const Polygon& ring);
double Area(const PolygonWithHoles& polygon);
double Area(const MultiPolygon& polygons);

/// Returns the centre of mass of a ring, or the mean of its points if the area is zero. REQUIRES:
/// ring not empty.
Point Centroid(const Polygon& ring);

/// Returns the length in nm of an open line, or of a ring including its closing edge.
double Length(std::span<const Point> line);
double Perimeter(const Polygon& ring);

enum class Side { kOutside, kBoundary, kInside };

/// Returns the position of p relative to the ring; exact, by crossing number. Cost: O(n).
Side Locate(Point p, const Polygon& ring);
Side Locate(Point p, const PolygonWithHoles& polygon);

/// Returns the point of the segment ab nearest to p, rounded to nm.
Point NearestOnSegment(Point p, Point a, Point b);

/// Returns the distance in nm from p to the segment ab.
double DistanceToSegment(Point p, Point a, Point b);

}  // namespace slicefarm
