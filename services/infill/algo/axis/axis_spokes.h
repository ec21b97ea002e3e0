#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::infill {

/// Returns the straight lines that join an island's main axis to those of its rings that no end of
/// the axis reaches, one for each such ring: from the ring's point nearest to the axis to the
/// axis. An axis ends short of a round end, and goes round a hole: lines at even distances from it
/// would be rings there, which hold to no wall. With the spokes, every ring of the island is
/// reached.
/// Cost: O(n m), n points of the island, m of the axis.
/// REQUIRES: the axis has at least one line.
std::vector<Polyline> AxisSpokes(const PolygonWithHoles& island, const std::vector<Polyline>& axis);

}  // namespace slicefarm::infill
