#pragma once

#include <vector>

#include "common/geometry/polygon.h"
#include "common/model/path.h"

namespace slicefarm::infill {

/// Beads along the middle of each island (MainAxis) that are at least so long. They end where the
/// widest circle inside an end of the island has its middle. Cost: that of MainAxis.
std::vector<Path> MiddleLines(const MultiPolygon& area, Coord width_nm, double least_nm);

}  // namespace slicefarm::infill
