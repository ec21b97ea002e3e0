#pragma once

#include <cmath>

#include "common/geometry/point.h"

namespace slicefarm::exposure {

/// Returns the point `by_nm` beyond `to` on the line from `from`, or `to` if both points are equal.
inline Point Beyond(Point from, Point to, Coord by_nm) {
  const double length = Distance(from, to);
  if (by_nm == 0 || length == 0) return to;
  const double share = static_cast<double>(by_nm) / length;
  return to + Point{std::llround(share * static_cast<double>(to.x - from.x)),
                    std::llround(share * static_cast<double>(to.y - from.y))};
}

}  // namespace slicefarm::exposure
