#include "common/geometry/line_axes.h"

#include <cmath>
#include <numbers>

#include "common/base/portable_math.h"

namespace slicefarm {
namespace {

double SnapToRightAngle(double value) {
  if (std::abs(value) < 1e-12) return 0;
  return std::abs(std::abs(value) - 1) < 1e-12 ? std::copysign(1.0, value) : value;
}

}  // namespace

LineAxes::LineAxes(double angle_rad)
    : cos_(SnapToRightAngle(Cos(angle_rad))), sin_(SnapToRightAngle(Sin(angle_rad))) {}

LineAxes LineAxes::OfDegrees(double angle_deg) {
  return LineAxes((angle_deg - 360 * std::floor(angle_deg / 360)) * std::numbers::pi / 180);
}

}  // namespace slicefarm
