#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::infill {

/// Position on the edge of a region. Rings are numbered in the order of ForEachRing, and edge i
/// connects a ring's point i with the next point.
struct EdgePlace {
  int32_t ring = -1;  ///< -1: the position is inside the region
  int32_t edge = 0;
};

/// Part of one line of a pattern inside a region. Its ends are on the region's edge, where links
/// can be attached, or are ends of the pattern's own line.
struct Piece {
  Polyline points;  ///< at least two points
  EdgePlace from{};
  EdgePlace to{};
  /// The last point joins the first, which is not repeated; there are no ends.
  bool closed = false;
};

}  // namespace slicefarm::infill
