#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::infill {

/// Position on the boundary of a region. Rings are numbered in the order of ForEachRing, and edge i
/// connects a ring's point i with the next point.
struct EdgePosition {
  int32_t ring = -1;  ///< -1: the position is inside the region
  int32_t edge = 0;
};

/// Part of one line of a pattern inside a region. Each end is either on the region's boundary,
/// where links can be attached, or an end of the pattern's own line, inside the region.
struct Piece {
  Polyline points;  ///< at least two points
  EdgePosition from{};
  EdgePosition to{};
  /// True if the piece continues from its last point to its first one, which is not repeated. Then
  /// it has no ends.
  bool closed = false;
};

}  // namespace slicefarm::infill
