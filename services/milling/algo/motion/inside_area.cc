#include "services/milling/algo/motion/inside_area.h"

#include <algorithm>

#include "common/geometry/measure.h"
#include "services/milling/algo/strategy/plane.h"

namespace slicefarm::milling {
namespace {

constexpr double kEndNm = 5'000;

/// Returns true if two segments cross, each one from one side of the other to its other side.
bool ProperlyCross(Point a, Point b, Point c, Point d) {
  const double c_side = Cross(b - a, c - a), d_side = Cross(b - a, d - a);
  const double a_side = Cross(d - c, a - c), b_side = Cross(d - c, b - c);
  return ((c_side > 0) != (d_side > 0)) && ((a_side > 0) != (b_side > 0)) && c_side != 0 &&
         d_side != 0 && a_side != 0 && b_side != 0;
}

bool CrossesRing(const Polygon& ring, Point a, Point b) {
  const Coord low_x = std::min(a.x, b.x), high_x = std::max(a.x, b.x);
  const Coord low_y = std::min(a.y, b.y), high_y = std::max(a.y, b.y);
  for (size_t i = 0; i < ring.size(); ++i) {
    const Point c = ring[i], d = ring[i + 1 == ring.size() ? 0 : i + 1];
    if (std::max(c.x, d.x) < low_x || std::min(c.x, d.x) > high_x) continue;
    if (std::max(c.y, d.y) < low_y || std::min(c.y, d.y) > high_y) continue;
    if (ProperlyCross(a, b, c, d)) return true;
  }
  return false;
}

bool FarOutside(const PolygonWithHoles& area, Point p) {
  if (Locate(p, area) != Side::kOutside) return false;
  const auto near = [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i)
      if (DistanceToSegment(p, ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]) <= kEndNm)
        return true;
    return false;
  };
  return !near(area.outer) && std::none_of(area.holes.begin(), area.holes.end(), near);
}

bool SegmentInside(const PolygonWithHoles& area, Point a, Point b) {
  const double length = Distance(a, b);
  const Point middle{a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2};
  if (length > 4 * kEndNm) {
    const double share = kEndNm / length;
    const Point end{static_cast<Coord>(static_cast<double>(b.x - a.x) * share),
                    static_cast<Coord>(static_cast<double>(b.y - a.y) * share)};
    a = a + end, b = b - end;
  }
  for (const Point p : {a, middle, b})
    if (FarOutside(area, p)) return false;
  if (CrossesRing(area.outer, a, b)) return false;
  for (const Polygon& hole : area.holes)
    if (CrossesRing(hole, a, b)) return false;
  return true;
}

}  // namespace

bool InsideArea(const PolygonWithHoles& area, std::span<const Eigen::Vector2d> line_mm) {
  for (size_t i = 0; i + 1 < line_mm.size(); ++i)
    if (!SegmentInside(area, PointOf(line_mm[i]), PointOf(line_mm[i + 1]))) return false;
  return true;
}

}  // namespace slicefarm::milling
