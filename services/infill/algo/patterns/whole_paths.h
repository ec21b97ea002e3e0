#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

// One path through each connected part of a region, with the first line along its boundary
// (space_filling/). The path returns to its start, so any straight cut through the part crosses it
// an even number of times. The length per area is therefore only approximately 1 / pitch; it is
// exact where many lines are side by side. The path does not depend on PatternContext::angle_rad or
// on the layer.

/// Connected Fermat spirals.
MakePattern Fermat;
/// Hilbert's curve on the blocks of a quadtree, with loops between the blocks and the boundary.
MakePattern HilbertQuadtree;
MakePattern PeanoQuadtree;

}  // namespace slicefarm::infill
