#pragma once

#include <cstddef>
#include <span>

#include "common/geometry/point.h"

namespace slicefarm {

/// A place on a loop: on the edge from point `edge` to the next; `at` is that point itself if it
/// lies there.
struct LoopPlace {
  size_t edge = 0;
  Point at;

  friend bool operator==(const LoopPlace&, const LoopPlace&) = default;
};

/// The place nearest to `to`, wherever it lies. REQUIRES: loop not empty.
/// Cost: O(n).
LoopPlace NearestPlace(std::span<const Point> loop, Point to);

}  // namespace slicefarm
