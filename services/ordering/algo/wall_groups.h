#pragma once

#include <cstdint>
#include <vector>

#include "common/model/path.h"

namespace slicefarm::ordering {

/// Two walls side by side, of successive insets.
struct WallPair {
  uint32_t outer = 0;
  uint32_t inner = 0;

  friend bool operator==(const WallPair&, const WallPair&) = default;
};

/// The walls along one contour of an island.
struct WallGroup {
  std::vector<Path*> walls;     ///< by inset, the outermost first; not empty
  std::vector<WallPair> pairs;  ///< indices into `walls`: each but the outermost is inner in one

  const Path& Outermost() const { return *walls.front(); }
};

/// Groups the walls of an island: those of inset 0 begin a group each; a wall of inset k belongs
/// with the wall of inset k - 1 that is nearest to its least point, and begins a group of its own
/// where there is none. A loop that runs along two contours goes with one of them. Shapes: each
/// wall in one group. Walls keep their order. Cost: O(walls * points of the walls near by).
std::vector<WallGroup> GroupWalls(const std::vector<Path*>& walls);

}  // namespace slicefarm::ordering
