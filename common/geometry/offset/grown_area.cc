#include "common/geometry/offset/grown_area.h"

#include <cmath>

#include "common/geometry/measure.h"
#include "common/geometry/vector.h"

namespace slicefarm {
namespace {

/// Returns a lower bound of the arc tangent for t >= 0. Source: Shafer 1966.
double LeastArcTangent(double t) { return 3 * t / (1 + 2 * std::sqrt(1 + t * t)); }

/// Returns the area that a ring gains when its edges move to the right by the distance: a rectangle
/// at each edge, a sector at each corner to the left. At a corner to the right, two rectangles
/// overlap.
double GainOf(const Polygon& ring, double distance) {
  double length = 0, corners = 0;
  Vector2 before = ToVector(ring[0] - ring.back());
  double before_length = Norm(before);
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vector2 edge = ToVector(ring[i + 1 == ring.size() ? 0 : i + 1] - ring[i]);
    const double edge_length = Norm(edge);
    if (edge_length == 0) continue;
    length += edge_length;
    if (before_length > 0) {
      // Tangent of half the turn.
      const double tangent =
          Cross(before, edge) / (before_length * edge_length + Dot(before, edge));
      corners += tangent > 0 ? LeastArcTangent(tangent) : tangent;
    }
    before = edge;
    before_length = edge_length;
  }
  return distance * length + distance * distance * corners;
}

}  // namespace

double LeastGrownArea(const PolygonWithHoles& island, Coord distance_nm) {
  const auto distance = static_cast<double>(distance_nm);
  double area = Area(island) + GainOf(island.outer, distance);
  for (const Polygon& hole : island.holes) area += GainOf(hole, distance);
  return area;
}

}  // namespace slicefarm
