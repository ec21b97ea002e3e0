#pragma once

#include <Eigen/Core>

#include "common/geometry/point.h"

namespace slicefarm::milling {

/// Converts x and y in mm, as used by the milling service, to a Point in nm.
inline Point PointOf(const Eigen::Vector2d& place_mm) {
  return {FromMm(place_mm.x()), FromMm(place_mm.y())};
}
/// Converts a Point in nm to x and y in mm, as used by the milling service.
inline Eigen::Vector2d PointMmOf(Point p) {
  return {ToMm(static_cast<double>(p.x)), ToMm(static_cast<double>(p.y))};
}

}  // namespace slicefarm::milling
