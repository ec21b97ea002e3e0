#pragma once

#include <cstdint>
#include <vector>

#include "common/model/path.h"

namespace slicefarm::ordering {

/// Two walls side by side with consecutive insets.
struct WallPair {
  uint32_t outer = 0;
  uint32_t inner = 0;

  friend bool operator==(const WallPair&, const WallPair&) = default;
};

/// Walls along one contour of an island.
struct WallGroup {
  std::vector<Path*> walls;  ///< walls sorted by inset, the outermost first; at least one
  /// indices into `walls`; each wall except the outermost is `inner` in one pair
  std::vector<WallPair> pairs;

  /// Returns the wall nearest to the outline.
  const Path& Outermost() const { return *walls.front(); }
};

/// Groups the walls of an island by contour. Each wall of inset 0 begins a group. A wall of inset k
/// joins the group of the wall of inset k - 1 that is nearest to its smallest point (LeastPoint).
/// If there is no wall of inset k - 1 near by, wall k begins a group. If a loop follows two
/// contours, it belongs to one of the two groups. Shapes: each wall is in one group. The walls of a
/// group keep their order. Cost: O(walls * points of the walls near by).
std::vector<WallGroup> GroupWalls(const std::vector<Path*>& walls);

}  // namespace slicefarm::ordering
