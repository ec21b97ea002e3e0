#pragma once

#include <Eigen/Core>

#include "common/geometry/point.h"

namespace slicefarm::milling {

/// Converts a position of this library, in mm, to a point of common/geometry, in nm.
inline Point PointOf(const Eigen::Vector2d& place_mm) {
  return {FromMm(place_mm.x()), FromMm(place_mm.y())};
}
/// Converts a point of common/geometry, in nm, to a position of this library, in mm.
inline Eigen::Vector2d PlaceOf(Point p) {
  return {ToMm(static_cast<double>(p.x)), ToMm(static_cast<double>(p.y))};
}

}  // namespace slicefarm::milling
