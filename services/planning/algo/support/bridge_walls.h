#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// Walls of an overhang along its free edges. A free edge has nothing of the layer below beyond it.
struct BridgeWalls {
  MultiPolygon area;
  /// Part of `area` with straight walls that rest on the layer below at both ends. The remaining
  /// walls have turns in the air.
  MultiPolygon held;
};

/// Returns the walls of `part`, with a total thickness of `walls_nm`. `part` is a connected piece
/// of the area beyond `below`. A wall is straight if it bends by at most a tenth of a millimetre.
/// Its end rests on `below` if `below` continues a tenth of a millimetre beyond the end. Cost:
/// O(edges of the part * edges of `below`), and a union of the walls.
BridgeWalls WallsOf(const PolygonWithHoles& part, const MultiPolygon& below, Coord walls_nm);

}  // namespace slicefarm::planning
