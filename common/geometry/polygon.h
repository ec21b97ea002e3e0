#pragma once

#include <vector>

#include "common/geometry/point.h"

namespace slicefarm {

/// A closed ring. The last point does not repeat the first. Outer rings run counter-clockwise,
/// holes clockwise.
using Polygon = std::vector<Point>;

/// An open line of at least two points.
using Polyline = std::vector<Point>;

/// One island: an outer ring and the holes in it.
struct PolygonWithHoles {
  Polygon outer;
  std::vector<Polygon> holes;

  friend bool operator==(const PolygonWithHoles&, const PolygonWithHoles&) = default;
};

/// Disjoint islands. The functions of this folder return them in canonical form (see Canonicalize).
using MultiPolygon = std::vector<PolygonWithHoles>;

/// Brings islands into canonical form: rotates each ring so that it starts at its smallest point,
/// and sorts holes and islands. Regions with the same rings then compare equal, independent of
/// their original order. Cost: O(n + k log k) for n points in k rings.
void Canonicalize(MultiPolygon& polygons);

/// Calls visit(ring) for all rings: each outer ring, followed by its holes.
template <typename Visit>
void ForEachRing(const MultiPolygon& polygons, Visit visit) {
  for (const PolygonWithHoles& polygon : polygons) {
    visit(polygon.outer);
    for (const Polygon& hole : polygon.holes) visit(hole);
  }
}

/// Returns copies of all rings, in the order of ForEachRing.
std::vector<Polygon> Rings(const MultiPolygon& polygons);

/// Returns the number of points of all rings.
size_t PointCount(const MultiPolygon& polygons);

}  // namespace slicefarm
