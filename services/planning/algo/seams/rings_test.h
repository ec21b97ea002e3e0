#pragma once

#include <cmath>
#include <numbers>

#include "common/geometry/polygon.h"

namespace slicefarm::planning {

inline Point Mm(double x, double y) { return {FromMm(x), FromMm(y)}; }

/// Returns a ring of `points` points on a circle.
inline Polygon CircleRing(Point center, double radius_mm, int points, double phase_rad = 0) {
  Polygon ring;
  for (int i = 0; i < points; ++i) {
    const double angle = phase_rad + 2 * std::numbers::pi * i / points;
    ring.push_back(center + Mm(radius_mm * std::cos(angle), radius_mm * std::sin(angle)));
  }
  return ring;
}

/// Returns a rotated square around the origin.
inline Polygon TurnedSquare(double side_mm, double angle_rad) {
  return CircleRing({}, side_mm / std::numbers::sqrt2, 4, angle_rad + std::numbers::pi / 4);
}

}  // namespace slicefarm::planning
