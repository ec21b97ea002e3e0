#include "services/exposure/algo/decompose/edge_point.h"

#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <numeric>

#include "common/geometry/predicates.h"

namespace slicefarm::exposure {
namespace {

/// Returns the point at `share` of the edge, rounded to a point that is not to the right of the
/// edge.
EdgePoint Rounded(Point a, Point b, double share) {
  const Point at{a.x + std::llround(share * static_cast<double>(b.x - a.x)),
                 a.y + std::llround(share * static_cast<double>(b.y - a.y))};
  // The point is moved by one unit to the left of the edge, along x for a steep edge, else along y.
  const bool steep = std::abs(b.y - a.y) > std::abs(b.x - a.x);
  const Point left = steep ? Point{b.y > a.y ? -1 : 1, 0} : Point{0, b.x > a.x ? 1 : -1};
  for (const Point p : {at, at + left}) {
    if (const int side = Orientation(a, b, p); side >= 0) return {p, side == 0};
  }
  return {at + left + left, false};
}

}  // namespace

EdgePoint PointOnEdge(Point a, Point b, double low, double high) {
  const Point edge = b - a;
  const Coord parts = std::gcd(std::abs(edge.x), std::abs(edge.y));
  const double middle = 0.5 * (low + high);
  const double whole = static_cast<double>(parts);
  for (Coord step = parts; step > 0;) {
    const Coord at = std::llround(middle * whole / static_cast<double>(step)) * step;
    const double share = static_cast<double>(at) / whole;
    if (low < share && share < high && at > 0 && at < parts)
      return {Point{a.x + edge.x / parts * at, a.y + edge.y / parts * at}, true};
    if (step == 1) break;
    step = step % 2 == 0 ? step / 2 : step % 5 == 0 ? step / 5 : 1;
  }
  return Rounded(a, b, middle);
}

}  // namespace slicefarm::exposure
