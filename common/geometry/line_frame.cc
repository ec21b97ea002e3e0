#include "common/geometry/line_frame.h"

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

LineFrame::LineFrame(double angle_rad)
    : cos_(SnapToRightAngle(Cos(angle_rad))), sin_(SnapToRightAngle(Sin(angle_rad))) {}

LineFrame LineFrame::OfDegrees(double angle_deg) {
  return LineFrame((angle_deg - 360 * std::floor(angle_deg / 360)) * std::numbers::pi / 180);
}

}  // namespace slicefarm
