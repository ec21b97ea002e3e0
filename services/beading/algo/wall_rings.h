#pragma once

#include <vector>

#include "common/geometry/polygon.h"
#include "common/model/path.h"

namespace slicefarm::beading {

/// Stores in each closed wall of inset 0 (Path::ring) the index of the ring of `outline` that it
/// follows: the ring nearest to the wall's first point. If all rings are farther away than the
/// wall's width, the wall gets no ring; it is then along the boundary between two regions. Rings
/// are numbered by island, in each island the outer ring before holes. Cost: O(walls * points of
/// the rings with bounding boxes near the wall).
void NameRings(const MultiPolygon& outline, std::vector<Path>& walls);

}  // namespace slicefarm::beading
