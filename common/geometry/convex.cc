#include "common/geometry/convex.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "common/base/portable_math.h"
#include "common/geometry/measure.h"
#include "common/geometry/predicates.h"

namespace slicefarm {
namespace {

/// Returns the sign of Orientation. Uses doubles where their result is certain, and exact integers
/// elsewhere.
int QuickOrientation(Point a, Point b, Point c) {
  const double left = static_cast<double>(b.x - a.x) * static_cast<double>(c.y - a.y);
  const double right = static_cast<double>(b.y - a.y) * static_cast<double>(c.x - a.x);
  const double cross = left - right, doubt = (std::abs(left) + std::abs(right)) * 1e-15;
  return cross > doubt ? 1 : cross < -doubt ? -1 : Orientation(a, b, c);
}

/// Returns a value > 0 if the direction b is counter-clockwise of a. Exact.
int Turn(Point a, Point b) { return Orientation({0, 0}, a, b); }

Point EdgeFrom(const Polygon& ring, size_t i) { return ring[(i + 1) % ring.size()] - ring[i]; }

size_t EdgeCount(const Polygon& convex) { return convex.size() < 2 ? 0 : convex.size(); }

double DistanceToEdges(Point p, const Polygon& ring) {
  double least = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < ring.size(); ++i)
    least = std::min(least, DistanceToSegment(p, ring[i], ring[(i + 1) % ring.size()]));
  return least;
}

}  // namespace

Polygon ConvexHull(std::vector<Point> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  Polygon hull;
  // Algorithm: Andrew's monotone chain.
  const auto add_chain = [&hull](auto begin, auto end) {
    const size_t base = hull.size();
    for (auto it = begin; it != end; ++it) {
      while (hull.size() >= base + 2 && Orientation(hull.end()[-2], hull.back(), *it) <= 0)
        hull.pop_back();
      hull.push_back(*it);
    }
    hull.pop_back();
  };
  add_chain(points.begin(), points.end());
  add_chain(points.rbegin(), points.rend());
  return hull;
}

Polygon ConvexSum(const Polygon& a, const Polygon& b) {
  if (a.empty() || b.empty()) return {};
  const size_t n = EdgeCount(a), m = EdgeCount(b);
  Polygon sum = {a[0] + b[0]};
  for (size_t i = 0, j = 0; i < n || j < m;) {
    const int turn = i == n ? -1 : j == m ? 1 : Turn(EdgeFrom(a, i), EdgeFrom(b, j));
    Point next = sum.back();
    if (turn >= 0) next = next + EdgeFrom(a, i++);
    if (turn <= 0) next = next + EdgeFrom(b, j++);
    sum.push_back(next);
  }
  if (sum.size() > 1) sum.pop_back();
  return sum;
}

Polygon Negated(const Polygon& convex) {
  Polygon negated;
  negated.reserve(convex.size());
  for (const Point p : convex) negated.push_back({-p.x, -p.y});
  return ConvexHull(std::move(negated));
}

Polygon DiscCover(Coord radius_nm) {
  constexpr Coord kFine = 10 * kNmPerMm;
  const int corners = radius_nm > kFine ? 32 : 16;
  const double half = std::numbers::pi / corners;
  std::vector<Point> points;
  for (int i = 0; i < corners; ++i) {
    // Corners are rounded away from the centre, so that rounding never moves a corner into the
    // disc.
    const double angle = (2 * i + 1) * half, reach = radius_nm / Cos(half);
    const auto outward = [](double v) {
      const double tidy = std::round(v * 16) / 16;  // removes the last bits, which depend on libm
      return static_cast<Coord>(tidy < 0 ? std::floor(tidy) : std::ceil(tidy));
    };
    points.push_back({outward(reach * Cos(angle)), outward(reach * Sin(angle))});
  }
  return ConvexHull(std::move(points));
}

bool StrictlyInside(Point p, const Polygon& convex) {
  const size_t n = convex.size();
  if (n < 3 || QuickOrientation(convex[0], convex[1], p) <= 0 ||
      QuickOrientation(convex[0], convex[n - 1], p) >= 0)
    return false;
  // Binary search: finds the triangle of the fan around the first corner that has p in its angle.
  size_t left = 1, right = n - 1;
  while (right - left > 1) {
    const size_t middle = (left + right) / 2;
    (QuickOrientation(convex[0], convex[middle], p) >= 0 ? left : right) = middle;
  }
  return QuickOrientation(convex[left], convex[right], p) > 0;
}

double ConvexDistance(const Polygon& a, const Polygon& b) {
  const Polygon difference = ConvexSum(a, Negated(b));
  const Point origin = {0, 0};
  if (StrictlyInside(origin, difference)) return 0;
  return DistanceToEdges(origin, difference);
}

}  // namespace slicefarm
