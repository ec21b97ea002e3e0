#pragma once

#include "common/geometry/point.h"

namespace slicefarm {

/// Coordinate axes rotated about the origin: u is along a direction, v is to its left. Parallel
/// lines are laid out in these axes. Rotations by multiples of a right angle are exact.
class LineAxes {
 public:
  /// Makes axes with u at an angle in radians.
  explicit LineAxes(double angle_rad);
  /// Returns axes with u at an angle in degrees; exact for all multiples of a right angle.
  static LineAxes OfDegrees(double angle_deg);

  /// Returns the u coordinate of p.
  double U(Point p) const {
    return cos_ * static_cast<double>(p.x) + sin_ * static_cast<double>(p.y);
  }
  /// Returns the v coordinate of p.
  double V(Point p) const {
    return cos_ * static_cast<double>(p.y) - sin_ * static_cast<double>(p.x);
  }
  /// Returns the point at (u, v), rounded to nm.
  Point At(double u, double v) const {
    return {Rounded(cos_ * u - sin_ * v), Rounded(sin_ * u + cos_ * v)};
  }

 private:
  /// Returns llround(x) for |x| far below 2^52; much faster than llround.
  static Coord Rounded(double x) { return static_cast<Coord>(x < 0 ? x - 0.5 : x + 0.5); }

  double cos_;
  double sin_;
};

}  // namespace slicefarm
