#pragma once

#include <cstdint>
#include <set>
#include <span>

#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// The room that a copy takes of the plate, with what is put around it.
struct TakenRoom {
  int32_t object = 0;
  Box box;
};

/// The objects none of whose copies meets the room of another copy or the edge of the bed: what is
/// put around them is their own. Cost: O(copies^2).
std::set<int32_t> ObjectsAlone(std::span<const TakenRoom> copies, const MultiPolygon& bed);

}  // namespace slicefarm::planning
