#pragma once

#include <cstdint>

#include "common/geometry/polygon.h"

namespace slicefarm::infill {

/// A way along a ring, from a place on one of its edges to a place on another. Edge i goes from
/// point i to the next.
struct RingWay {
  int32_t from_edge = 0;
  int32_t to_edge = 0;
  bool forward = true;
  bool around = false;  ///< if both edges are the same: round the whole ring
};

/// Calls visit for the corners that the way passes, in order.
template <typename Visit>
void ForEachCorner(const Polygon& ring, const RingWay& way, Visit visit) {
  const auto size = static_cast<int32_t>(ring.size());
  int32_t corners = way.forward ? way.to_edge - way.from_edge : way.from_edge - way.to_edge;
  if (corners < 0 || (corners == 0 && way.around)) corners += size;
  // Point e + 1 ends edge e, so going back the first corner is point e itself.
  for (int32_t at = way.forward ? way.from_edge + 1 : way.from_edge; corners > 0; --corners) {
    visit(ring[(at + size) % size]);
    at += way.forward ? 1 : -1;
  }
}

}  // namespace slicefarm::infill
