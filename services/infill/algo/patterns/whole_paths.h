#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// One path through each connected part of a region, with the first line along its boundary
/// (space_filling/). The path returns to its start, so that any straight cut through the part
/// crosses an even number of lines. The length per area is therefore only approximately 1 / pitch;
/// it is exact where many lines are side by side. The path does not depend on the origin's angle or
/// on the layer.

/// Connected Fermat spirals.
MakePattern Fermat;
/// Hilbert's and Peano's curves on the blocks of a quadtree, in a band of loops.
MakePattern HilbertQuadtree;
MakePattern PeanoQuadtree;

}  // namespace slicefarm::infill
