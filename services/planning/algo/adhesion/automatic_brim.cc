#include "services/planning/algo/adhesion/automatic_brim.h"

#include <algorithm>

#include "common/base/portable_math.h"
#include "common/geometry/measure.h"

namespace slicefarm::planning {
namespace {

constexpr double kLeastMm = 5;
constexpr double kMostMm = 18;
constexpr double kThinWallMm = 1.1;  ///< area divided by the length of the outlines
constexpr double kTallMm = 10;

/// Moments of an area up to the second order, in mm.
struct Moments {
  double area = 0;
  double x = 0, y = 0;
  double xx = 0, yy = 0;  ///< integrals of x^2 and y^2

  /// Adds the moments of a ring. Holes run clockwise, so their moments are subtracted.
  void Add(const Polygon& ring) {
    Point before = ring.back();
    for (const Point next : ring) {
      const double ax = ToMm(static_cast<double>(before.x)),
                   ay = ToMm(static_cast<double>(before.y));
      const double bx = ToMm(static_cast<double>(next.x)), by = ToMm(static_cast<double>(next.y));
      const double cross = ax * by - ay * bx;
      area += cross / 2;
      x += cross * (ax + bx) / 6;
      y += cross * (ay + by) / 6;
      xx += cross * (ax * ax + ax * bx + bx * bx) / 12;
      yy += cross * (ay * ay + ay * by + by * by) / 12;
      before = next;
    }
  }

  /// Second moment about the centroid of the area.
  double OverX() const { return yy - y * y / area; }
  double OverY() const { return xx - x * x / area; }
};

double OutlineLength(const MultiPolygon& outlines) {
  double length = 0;
  for (const PolygonWithHoles& island : outlines) {
    Point before = island.outer.back();
    for (const Point next : island.outer) {
      length += ToMm(Distance(before, next));
      before = next;
    }
  }
  return length;
}

}  // namespace

Coord AutomaticBrimWidth(const AutomaticBrim& brim, const MultiPolygon& first_layer,
                         Coord height_nm) {
  if (first_layer.empty()) return 0;
  Moments moments;
  ForEachRing(first_layer, [&](const Polygon& ring) { moments.Add(ring); });
  const Box box = Bounds(first_layer);
  const double wide = ToMm(static_cast<double>(box.max.x - box.min.x));
  const double deep = ToMm(static_cast<double>(box.max.y - box.min.y));
  const double high = ToMm(static_cast<double>(height_nm));
  const double across = Hypot(wide, deep);
  const double falls =
      std::max(high / moments.OverX() * deep, high / moments.OverY() * wide) * high / 1920;
  const double warps = across * 8 / brim.thermal_length_mm * std::min(high, 30.0) / 30;
  double width = brim.adhesion *
                 std::min({std::max(falls * brim.max_speed_mm_s, warps), kMostMm, 1.5 * across});
  if (width < kLeastMm && width < 1.5 * across) width = 0;
  const bool thin = moments.area / OutlineLength(first_layer) < kThinWallMm;
  if (width == 0 && thin && high > kTallMm) width = kLeastMm;
  return FromMm(std::min({width, kMostMm, std::max(wide, deep)}));
}

}  // namespace slicefarm::planning
