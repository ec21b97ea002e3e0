#pragma once

#include <cmath>
#include <vector>

#include "common/geometry/point.h"
#include "common/geometry/polygon.h"

namespace slicefarm::exposure {

/// A place in nm, not rounded yet.
struct PlaneVector {
  double x = 0;
  double y = 0;

  friend PlaneVector operator-(PlaneVector a, PlaneVector b) { return {a.x - b.x, a.y - b.y}; }
};
inline double Cross(PlaneVector a, PlaneVector b) { return a.x * b.y - a.y * b.x; }
inline double Dot(PlaneVector a, PlaneVector b) { return a.x * b.x + a.y * b.y; }
inline double Norm(PlaneVector a) { return std::sqrt(Dot(a, a)); }
inline Point Rounded(PlaneVector p) { return {std::llround(p.x), std::llround(p.y)}; }

using ConvexRing = std::vector<PlaneVector>;

/// Coordinates of the piece are in 1 / `scale` nm.
inline ConvexRing ConvexRingOf(const Polygon& piece, double scale) {
  ConvexRing ring;
  for (const Point p : piece)
    ring.push_back({static_cast<double>(p.x) / scale, static_cast<double>(p.y) / scale});
  return ring;
}

}  // namespace slicefarm::exposure
