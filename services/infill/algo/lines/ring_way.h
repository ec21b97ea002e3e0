#pragma once

#include <cstdint>

#include "common/geometry/polygon.h"

namespace slicefarm::infill {

/// Path along a ring, from a position on one of its edges to a position on another edge. Edge i
/// connects point i with the next point.
struct RingWay {
  int32_t from_edge = 0;
  int32_t to_edge = 0;
  bool forward = true;
  bool around = false;  ///< only if both edges are the same: true if the path passes the whole ring
};

/// Calls visit(point) for the corners of the ring that the path passes, in the path's order.
template <typename Visit>
void ForEachCorner(const Polygon& ring, const RingWay& way, Visit visit) {
  const auto size = static_cast<int32_t>(ring.size());
  int32_t corners = way.forward ? way.to_edge - way.from_edge : way.from_edge - way.to_edge;
  if (corners < 0 || (corners == 0 && way.around)) corners += size;
  // Point e + 1 is the end of edge e, so that in backward direction the first corner is point e.
  for (int32_t at = way.forward ? way.from_edge + 1 : way.from_edge; corners > 0; --corners) {
    visit(ring[(at + size) % size]);
    at += way.forward ? 1 : -1;
  }
}

}  // namespace slicefarm::infill
