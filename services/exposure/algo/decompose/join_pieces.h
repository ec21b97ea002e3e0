#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::exposure {

/// Takes away cuts between two convex pieces that are not needed: where what both cover is convex
/// too, and no longer for its area than the worse of the two. Best shapes first. Exact.
/// Cost: O(n log n).
std::vector<Polygon> JoinPieces(std::vector<Polygon> pieces);

/// Perimeter^2 / (4 pi area): 1 for a disc, 1.27 for a square.
double ShapeFactor(const Polygon& piece);

}  // namespace slicefarm::exposure
