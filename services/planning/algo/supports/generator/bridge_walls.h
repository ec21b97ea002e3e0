#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// Walls of an overhang along its free edges: edges beyond which the layer below has nothing.
struct BridgeWalls {
  MultiPolygon area;
  /// Part of `area` with walls that are straight and supported by the layer below at both ends. The
  /// remaining walls bend in the air.
  MultiPolygon held;
};

/// Returns the walls of `part` along its free edges, with a total thickness of `walls_nm`. `below`:
/// outlines of the layer below. `part`: a connected piece of the area that `below` does not cover.
/// A wall is straight if it bends by at most a tenth of a millimetre. The end of a wall is
/// supported if `below` continues a tenth of a millimetre beyond the end. Cost: O(n m) for n edges
/// of the part and m edges of `below`, and a union of the walls.
BridgeWalls WallsOf(const PolygonWithHoles& part, const MultiPolygon& below, Coord walls_nm);

}  // namespace slicefarm::planning
