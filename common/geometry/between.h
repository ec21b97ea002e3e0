#pragma once

#include <cmath>

#include "common/geometry/point.h"

namespace slicefarm {

/// The place on the way from `a` to `b` that has `share` of it behind; rounded to nm.
inline Point PointBetween(Point a, Point b, double share) {
  return {a.x + std::llround(share * static_cast<double>(b.x - a.x)),
          a.y + std::llround(share * static_cast<double>(b.y - a.y))};
}

}  // namespace slicefarm
