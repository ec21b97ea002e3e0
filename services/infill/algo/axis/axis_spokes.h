#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::infill {

/// Returns spokes, which connect rings of the island to its main axis (main_axis.h). For each ring
/// that no end of the axis touches, the spoke is the shortest straight line from a corner of the
/// ring to a point of the axis.
///
/// Without spokes, lines at constant distances from the axis would form closed rings around holes
/// and at round ends, and would touch no wall. Cost: O(n m), n points of the island, m points of
/// the axis. REQUIRES: the axis has at least one line.
std::vector<Polyline> AxisSpokes(const PolygonWithHoles& island, const std::vector<Polyline>& axis);

}  // namespace slicefarm::infill
