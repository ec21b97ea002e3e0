#pragma once

#include <cstdint>
#include <set>
#include <span>

#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// Bounding box of one copy's footprint on the plate, including its brim or raft.
struct CopyFootprint {
  int32_t object = 0;
  Box box;
};

/// Returns the objects that can have a brim or raft of their own: no copy of the object meets the
/// box of another copy or the boundary of the bed. Cost: O(copies^2).
std::set<int32_t> ObjectsAlone(std::span<const CopyFootprint> copies, const MultiPolygon& bed);

}  // namespace slicefarm::planning
