#pragma once

#include <cmath>
#include <numbers>

#include "common/base/portable_math.h"
#include "common/geometry/point.h"

namespace slicefarm::exposure {

/// Axes turned by an angle: u runs along it, v across. Origins are the same.
class ScanFrame {
 public:
  /// Multiples of a right angle are exact.
  explicit ScanFrame(double angle_deg) {
    const double quarters = std::floor(angle_deg / 90);
    const double rest_rad = (angle_deg - 90 * quarters) * std::numbers::pi / 180;
    cos_ = Cos(rest_rad);
    sin_ = Sin(rest_rad);
    for (int i = static_cast<int>(quarters - 4 * std::floor(quarters / 4)); i > 0; --i) {
      const double sine = sin_;
      sin_ = cos_;
      cos_ = -sine;
    }
  }

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
  /// Half away from zero, as llround, of what is far below 2^52.
  static Coord Rounded(double x) { return static_cast<Coord>(x < 0 ? x - 0.5 : x + 0.5); }

  double cos_ = 1;
  double sin_ = 0;
};

}  // namespace slicefarm::exposure
