#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::exposure {

/// Rotates the rings of a convex piece so that their starts are on one straight line. This line
/// leads from the point at the fraction `share` of the outermost ring's length to the nearest point
/// of the innermost ring. The links between rings are therefore short. The links move around the
/// piece when `share` changes.
///
/// rings: closed lines from the boundary inwards; the last may be an open line of two points. Their
/// shapes do not change. No ring begins on a spur (corner_spurs.h). Cost: O(points).
void StartAtShare(std::vector<Polyline>& rings, double share);

}  // namespace slicefarm::exposure
