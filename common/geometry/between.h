#pragma once

#include <cmath>

#include "common/geometry/point.h"

namespace slicefarm {

/// Returns the point of the segment from `a` to `b` at the fraction `share` of its length, rounded
/// to nm.
inline Point PointBetween(Point a, Point b, double share) {
  return {a.x + std::llround(share * static_cast<double>(b.x - a.x)),
          a.y + std::llround(share * static_cast<double>(b.y - a.y))};
}

}  // namespace slicefarm
