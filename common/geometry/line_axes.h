#pragma once

#include "common/geometry/point.h"

namespace slicefarm {

/// Axes turned about the origin: u runs along the direction, v across. Parallel lines are laid out
/// in it. Multiples of a right angle are exact.
class LineAxes {
 public:
  explicit LineAxes(double angle_rad);
  /// Exact at right angles, however large.
  static LineAxes OfDegrees(double angle_deg);

  double U(Point p) const {
    return cos_ * static_cast<double>(p.x) + sin_ * static_cast<double>(p.y);
  }
  double V(Point p) const {
    return cos_ * static_cast<double>(p.y) - sin_ * static_cast<double>(p.x);
  }
  /// Rounded to nm.
  Point At(double u, double v) const {
    return {Rounded(cos_ * u - sin_ * v), Rounded(sin_ * u + cos_ * v)};
  }

 private:
  /// As llround, of what is far below 2^52; many times as fast.
  static Coord Rounded(double x) { return static_cast<Coord>(x < 0 ? x - 0.5 : x + 0.5); }

  double cos_;
  double sin_;
};

}  // namespace slicefarm
