#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"

namespace slicefarm::slicing::counterbore_shapes_test {

/// Returns a regular polygon around (x, y) with a corner at `turn_rad`.
inline Polygon Ngon(double x_mm, double y_mm, double radius_mm, int corners, double turn_rad = 0) {
  Polygon ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = turn_rad + 2 * std::numbers::pi * i / corners;
    ring.push_back(
        {FromMm(x_mm + radius_mm * std::cos(angle)), FromMm(y_mm + radius_mm * std::sin(angle))});
  }
  return ring;
}

inline Polygon Disc(double x_mm, double y_mm, double radius_mm) {
  return Ngon(x_mm, y_mm, radius_mm, 90);
}

inline Polygon Box(double x_mm, double y_mm, double width_mm, double depth_mm) {
  const Coord left = FromMm(x_mm), right = FromMm(x_mm + width_mm);
  const Coord front = FromMm(y_mm), back = FromMm(y_mm + depth_mm);
  return {{left, front}, {right, front}, {right, back}, {left, back}};
}

inline Polygon AsHole(Polygon ring) {
  std::ranges::reverse(ring);
  return ring;
}

inline double Mm2(const MultiPolygon& outlines) { return Area(outlines) / 1e12; }

}  // namespace slicefarm::slicing::counterbore_shapes_test
