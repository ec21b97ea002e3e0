#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// What walls cover of an overhang along its free edges: those beyond which nothing lies below.
struct BridgeWalls {
  MultiPolygon area;
  /// Of it, what straight walls cover that run from one hold to another. The rest turns in the air.
  MultiPolygon held;
};

/// The walls of `part`, a connected part of what lies beyond `below`, `walls_nm` thick in all. A wall
/// is straight where it bends by no more than a tenth of a millimetre, and holds where `below` goes
/// on a tenth of a millimetre beyond its end. Cost: O(edges of the part * edges of `below`), and a
/// union of the walls.
BridgeWalls WallsOf(const PolygonWithHoles& part, const MultiPolygon& below, Coord walls_nm);

}  // namespace slicefarm::planning
