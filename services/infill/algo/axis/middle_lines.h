#pragma once

#include <vector>

#include "common/geometry/polygon.h"
#include "common/model/path.h"

namespace slicefarm::infill {

/// Returns beads of width `width_nm` along the lines of each island's main axis (MainAxis). Lines
/// shorter than `least_nm` are omitted. A bead ends at the centre of the largest circle that fits
/// into an end of the island. Cost: the cost of MainAxis.
std::vector<Path> MiddleLines(const MultiPolygon& area, Coord width_nm, double least_nm);

}  // namespace slicefarm::infill
