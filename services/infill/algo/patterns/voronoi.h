#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Edges of irregular cells of similar size: Voronoi cells of points that Lloyd's method has spread
/// over a tile (RelaxedCells). The tile repeats over the plane and is the same in all layers, so
/// that walls are vertical. Lines follow all edges without a stop. A third of the edges, the
/// shortest suitable ones, have two lines side by side (StrandTile). Density: the size of the tile
/// is chosen so that the length of all lines in it is its area / pitch. Doubled lines count twice.
MakePattern Voronoi;

}  // namespace slicefarm::infill
