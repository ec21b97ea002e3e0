#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::infill {

/// A place on the edge of a region: rings are numbered as ForEachRing visits them, edge i goes from
/// a ring's point i to the next.
struct EdgePlace {
  int32_t ring = -1;  ///< -1: the place is inside the region
  int32_t edge = 0;
};

/// What is left of one line of a pattern inside a region. Its ends lie on the region's edge, where
/// links may take hold, or are ends of the pattern's own line.
struct Piece {
  Polyline points;  ///< at least two
  EdgePlace from{};
  EdgePlace to{};
  bool closed = false;  ///< the last point joins the first, which is not repeated; no ends then
};

}  // namespace slicefarm::infill
