#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "services/milling/algo/strategy/mill_steps.h"

namespace slicefarm::milling {

/// Index of an area: the level, and the area in the level.
struct AreaIndex {
  uint32_t level = 0;
  uint32_t area = 0;

  friend bool operator==(const AreaIndex&, const AreaIndex&) = default;
};

/// Returns the order in which areas are cut. All areas of the level above that an area overlaps are
/// cut before it. If several areas are possible next, the order continues downwards, so that a
/// pocket is finished before the next one. REQUIRES: levels descend. Cost: O(n m) for two areas of
/// n and m points that have overlapping boxes but do not overlap; less otherwise.
std::vector<AreaIndex> CutOrder(std::span<const MilledStep> levels);

}  // namespace slicefarm::milling
