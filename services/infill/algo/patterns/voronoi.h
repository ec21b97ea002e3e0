#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Edges of irregular cells of similar size: Voronoi cells of points that Lloyd's method has spread
/// over a tile (RelaxedCells). The tile repeats over the plane and is the same in all layers, so
/// walls are vertical. One line follows all edges without a stop. For this it passes a third of the
/// edges twice, with two lines side by side: the matching edges with the smallest total length
/// (StrandTile). Density: the size of the tile is chosen so that the length of all lines in it is
/// its area / pitch.
MakePattern Voronoi;

}  // namespace slicefarm::infill
