#pragma once

#include <cstdint>
#include <set>
#include <span>

#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// Room on the plate that one copy needs together with its brim or raft.
struct TakenRoom {
  int32_t object = 0;
  Box box;
};

/// Returns the objects that keep their brim or raft to themselves. No copy of such an object meets
/// the room of another copy or the edge of the bed. Cost: O(copies^2).
std::set<int32_t> ObjectsAlone(std::span<const TakenRoom> copies, const MultiPolygon& bed);

}  // namespace slicefarm::planning
