#pragma once

#include <vector>

#include "common/geometry/polygon.h"
#include "common/model/path.h"

namespace slicefarm::beading {

/// Stores in each closed wall of inset 0 the index of the ring of `outline` that it follows: the
/// ring nearest to the wall's first point. A wall that is farther from all rings than its own width
/// gets no ring; such walls are along the boundary between two regions. Rings are numbered by
/// island, outer ring before holes. Cost: O(walls * points of the rings with a near box).
void NameRings(const MultiPolygon& outline, std::vector<Path>& walls);

}  // namespace slicefarm::beading
