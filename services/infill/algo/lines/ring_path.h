#pragma once

#include <cstdint>

#include "common/geometry/polygon.h"

namespace slicefarm::infill {

/// Path along a ring, from a position on one of its edges to a position on another edge. Edge i
/// connects point i with the next point.
struct RingPath {
  int32_t from_edge = 0;
  int32_t to_edge = 0;
  bool forward = true;
  /// used only if both edges are the same: true if the path passes the whole ring
  bool around = false;
};

/// Calls visit(point) for the corners of the ring that the path passes, in the path's order.
template <typename Visit>
void ForEachCorner(const Polygon& ring, const RingPath& path, Visit visit) {
  const auto size = static_cast<int32_t>(ring.size());
  int32_t corners = path.forward ? path.to_edge - path.from_edge : path.from_edge - path.to_edge;
  if (corners < 0 || (corners == 0 && path.around)) corners += size;
  // Point e + 1 is the end of edge e, so that in backward direction the first corner is point e.
  for (int32_t at = path.forward ? path.from_edge + 1 : path.from_edge; corners > 0; --corners) {
    visit(ring[(at + size) % size]);
    at += path.forward ? 1 : -1;
  }
}

}  // namespace slicefarm::infill
