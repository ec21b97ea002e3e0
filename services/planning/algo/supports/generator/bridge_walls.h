#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// Walls of an overhang along its free edges: edges with nothing of the layer below beyond them.
struct BridgeWalls {
  MultiPolygon area;
  /// Part of `area` with straight walls that are supported by the layer below at both ends. The
  /// remaining walls bend in the air.
  MultiPolygon held;
};

/// Returns the walls of `part`, with a total thickness of `walls_nm`. `part` is a connected piece
/// of the area beyond `below`, the layer below. A wall is straight if it bends by at most a tenth
/// of a millimetre. The end of a wall is supported if `below` continues a tenth of a millimetre
/// beyond the end. Cost: O(n m) for n edges of the part and m edges of `below`, and a union of the
/// walls.
BridgeWalls WallsOf(const PolygonWithHoles& part, const MultiPolygon& below, Coord walls_nm);

}  // namespace slicefarm::planning
