#pragma once

#include <vector>

#include "common/geometry/polygon.h"
#include "common/model/path.h"

namespace slicefarm::beading {

/// Tells each closed wall of inset 0 which ring of `outline` it follows: the one that is nearest to
/// the wall's first point. A wall that is farther from all of them than its own width, as along the
/// border of two regions, follows none. Rings are numbered by island, outer ring before holes.
/// Cost: O(walls * points of the rings whose box is near).
void NameRings(const MultiPolygon& outline, std::vector<Path>& walls);

}  // namespace slicefarm::beading
