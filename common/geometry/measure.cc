#include "common/geometry/measure.h"

#include <algorithm>

#include "common/geometry/predicates.h"

namespace slicefarm {
namespace {

using Wide = __int128;

/// Returns twice the signed area; exact for rings within +-2^61 nm of their first point.
Wide DoubledArea(const Polygon& ring) {
  Wide sum = 0;
  const Point origin = ring.empty() ? Point{} : ring[0];
  for (size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i] - origin;
    const Point b = ring[i + 1 == ring.size() ? 0 : i + 1] - origin;
    sum += Wide{a.x} * b.y - Wide{a.y} * b.x;
  }
  return sum;
}

Point Mean(const Polygon& ring) {
  Wide x = 0, y = 0;
  for (const Point p : ring) x += p.x, y += p.y;
  const auto n = static_cast<double>(ring.size());
  return {std::llround(static_cast<double>(x) / n), std::llround(static_cast<double>(y) / n)};
}

}  // namespace

void Box::Add(Point p) {
  min = {std::min(min.x, p.x), std::min(min.y, p.y)};
  max = {std::max(max.x, p.x), std::max(max.y, p.y)};
}

void Box::Add(const Box& box) {
  if (box.Empty()) return;
  Add(box.min);
  Add(box.max);
}

bool Box::Intersects(const Box& other) const {
  return !Empty() && !other.Empty() && min.x <= other.max.x && other.min.x <= max.x &&
         min.y <= other.max.y && other.min.y <= max.y;
}

Box Box::Grown(Coord by) const {
  if (Empty()) return *this;
  return {{min.x - by, min.y - by}, {max.x + by, max.y + by}};
}

Box Bounds(std::span<const Point> points) {
  Box box;
  for (const Point p : points) box.Add(p);
  return box;
}

Box Bounds(const MultiPolygon& polygons) {
  Box box;
  for (const PolygonWithHoles& polygon : polygons) box.Add(Bounds(polygon.outer));
  return box;
}

double SignedArea(const Polygon& ring) { return static_cast<double>(DoubledArea(ring)) / 2; }

double Area(const PolygonWithHoles& polygon) {
  double area = SignedArea(polygon.outer);
  for (const Polygon& hole : polygon.holes) area += SignedArea(hole);
  return area;
}

double Area(const MultiPolygon& polygons) {
  double area = 0;
  for (const PolygonWithHoles& polygon : polygons) area += Area(polygon);
  return area;
}

Point Centroid(const Polygon& ring) {
  const Wide doubled_area = DoubledArea(ring);
  if (doubled_area == 0) return Mean(ring);
  // Coordinates are relative to the first point, so that the sums are precise far from the origin.
  const Point origin = ring[0];
  double x = 0, y = 0;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i] - origin;
    const Point b = ring[i + 1 == ring.size() ? 0 : i + 1] - origin;
    const double cross = Cross(a, b);
    x += static_cast<double>(a.x + b.x) * cross;
    y += static_cast<double>(a.y + b.y) * cross;
  }
  const double scale = 3 * static_cast<double>(doubled_area);
  return {origin.x + std::llround(x / scale), origin.y + std::llround(y / scale)};
}

double Length(std::span<const Point> line) {
  double length = 0;
  for (size_t i = 1; i < line.size(); ++i) length += Distance(line[i - 1], line[i]);
  return length;
}

double Perimeter(const Polygon& ring) {
  return ring.empty() ? 0 : Length(ring) + Distance(ring.back(), ring.front());
}

Side Locate(Point p, const Polygon& ring) {
  bool inside = false;
  for (size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Point a = ring[j], b = ring[i];
    if (p == b) return Side::kBoundary;
    if ((a.y > p.y) == (b.y > p.y)) {
      if (a.y == p.y && b.y == p.y && OnSegment(p, a, b)) return Side::kBoundary;
      continue;
    }
    const int turn = Orientation(a, b, p);
    if (turn == 0) return Side::kBoundary;
    if ((turn > 0) == (b.y > a.y)) inside = !inside;
  }
  return inside ? Side::kInside : Side::kOutside;
}

Side Locate(Point p, const PolygonWithHoles& polygon) {
  const Side outer = Locate(p, polygon.outer);
  if (outer != Side::kInside) return outer;
  for (const Polygon& hole : polygon.holes) {
    const Side side = Locate(p, hole);
    if (side == Side::kInside) return Side::kOutside;
    if (side == Side::kBoundary) return Side::kBoundary;
  }
  return Side::kInside;
}

Point NearestOnSegment(Point p, Point a, Point b) {
  const Point ab = b - a;
  const double squared = SquaredNorm(ab);
  if (squared == 0) return a;
  const double t = std::clamp(Dot(p - a, ab) / squared, 0.0, 1.0);
  return {a.x + std::llround(t * static_cast<double>(ab.x)),
          a.y + std::llround(t * static_cast<double>(ab.y))};
}

double DistanceToSegment(Point p, Point a, Point b) {
  const Point ab = b - a, ap = p - a;
  const double squared = SquaredNorm(ab);
  if (squared == 0) return Norm(ap);
  const double along = Dot(ap, ab);
  if (along <= 0) return Norm(ap);
  if (along >= squared) return Distance(p, b);
  return std::abs(Cross(ap, ab)) / std::sqrt(squared);
}

}  // namespace slicefarm
