#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// The edges of irregular cells of like size: Voronoi cells of places that Lloyd's method has
/// spread over a tile (RelaxedCells), which is repeated over the plane. The same in all layers:
/// walls are upright. Lines go along all edges without a stop, and along a third of them, the
/// shortest that will do, twice, side by side (StrandTile). Law: the tile is as large as makes the
/// length of all its lines, doubled ones counted twice, one pitch per area.
MakePattern Voronoi;

}  // namespace slicefarm::infill
