#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::exposure {

/// Turns the rings of a convex piece so that they begin on one straight way from its outermost ring
/// to its innermost one: from the place at `share` of the outermost ring's length to the nearest
/// place of the innermost. So links between rings are short, and all of them move with the share.
///
/// rings: closed lines from the border inwards; the last may be an open line of two points. They
/// keep their course; spurs (there and back) are never begun on. Cost: O(points).
void StartAtShare(std::vector<Polyline>& rings, double share);

}  // namespace slicefarm::exposure
