#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::exposure {

/// Rotates the rings of a convex piece so that their starts are on one straight line. It runs from
/// the point at `share` of the outermost ring's length to the nearest point of the innermost ring.
/// The links between rings are therefore short, and all of them move with the share.
///
/// rings: closed lines from the border inwards; the last may be an open line of two points. Their
/// shapes do not change. A ring never begins on a spur. Cost: O(points).
void StartAtShare(std::vector<Polyline>& rings, double share);

}  // namespace slicefarm::exposure
