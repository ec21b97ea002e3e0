#pragma once

#include <vector>

#include "common/geometry/polygon.h"
#include "common/model/path.h"

namespace slicefarm::infill {

/// Returns beads along the middle of each island (MainAxis) that are at least `least_nm` long. A
/// bead ends at the centre of the widest circle inside an end of the island. Cost: the cost of
/// MainAxis.
std::vector<Path> MiddleLines(const MultiPolygon& area, Coord width_nm, double least_nm);

}  // namespace slicefarm::infill
