#pragma once

#include <Eigen/Core>

#include "common/geometry/point.h"

namespace slicefarm::milling {

/// Between the ways of this library, in mm, and the regions of common/geometry, in nm.
inline Point PointOf(const Eigen::Vector2d& place_mm) {
  return {FromMm(place_mm.x()), FromMm(place_mm.y())};
}
inline Eigen::Vector2d PlaceOf(Point p) {
  return {ToMm(static_cast<double>(p.x)), ToMm(static_cast<double>(p.y))};
}

}  // namespace slicefarm::milling
