#pragma once

#include <vector>

#include "common/model/path.h"

namespace slicefarm::ordering {

/// The walls along one contour of an island, by inset: levels[0] holds the outermost.
struct WallGroup {
  std::vector<std::vector<Path*>> levels;  ///< none empty

  const Path& Outermost() const { return *levels.front().front(); }
};

/// Groups the walls of an island: those of inset 0 begin a group each; a wall of inset k belongs
/// with the wall of inset k - 1 that is nearest to its least point, and begins a group of its own
/// where there is none. A loop that runs along two contours goes with one of them. Shapes: each
/// wall in one group. Walls keep their order. Cost: O(walls * points of the walls near by).
std::vector<WallGroup> GroupWalls(const std::vector<Path*>& walls);

}  // namespace slicefarm::ordering
