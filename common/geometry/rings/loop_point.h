#pragma once

#include <cstddef>
#include <span>

#include "common/geometry/point.h"

namespace slicefarm {

/// A position on a loop: on the edge from point number `edge` to the next point, with the
/// coordinates `at`. If the position is at the first point of the edge, `at` equals this point.
struct LoopPoint {
  size_t edge = 0;
  Point at;

  friend bool operator==(const LoopPoint&, const LoopPoint&) = default;
};

/// Returns the position on the loop nearest to `to`. REQUIRES: loop not empty. Cost: O(n), n
/// points.
LoopPoint NearestLoopPoint(std::span<const Point> loop, Point to);

}  // namespace slicefarm
