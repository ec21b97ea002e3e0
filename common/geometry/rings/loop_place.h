#pragma once

#include <cstddef>
#include <span>

#include "common/geometry/point.h"

namespace slicefarm {

/// A position on a loop: on the edge from point `edge` to the next point. `at` is that point itself
/// if the position is there.
struct LoopPlace {
  size_t edge = 0;
  Point at;

  friend bool operator==(const LoopPlace&, const LoopPlace&) = default;
};

/// Returns the position on the loop nearest to `to`. REQUIRES: loop not empty. Cost: O(n).
LoopPlace NearestPlace(std::span<const Point> loop, Point to);

}  // namespace slicefarm
