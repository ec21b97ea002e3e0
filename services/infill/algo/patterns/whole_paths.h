#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// One path through each connected part of a region, the first line along its edge
/// (space_filling/). The path comes back to where it starts, so a place is crossed by an even
/// number of lines: length per area is 1 / pitch but for that, and exact only where many lines lie
/// side by side. Not tied to the origin's angle or layer.

/// Connected Fermat spirals.
MakePattern Fermat;
/// Hilbert's and Peano's curves on the blocks of a quadtree, in a band of loops.
MakePattern HilbertQuadtree;
MakePattern PeanoQuadtree;

}  // namespace slicefarm::infill
