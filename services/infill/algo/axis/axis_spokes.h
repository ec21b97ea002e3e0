#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::infill {

/// Connects rings of the island to its main axis. For each ring that no end of the axis touches,
/// returns the shortest straight line (spoke) from a corner of the ring to a point of the axis.
///
/// Without spokes, lines at even distances from the axis would form closed rings around holes and
/// at round ends, and would touch no wall. Cost: O(n m), n points of the island, m points of the
/// axis. REQUIRES: the axis has at least one line.
std::vector<Polyline> AxisSpokes(const PolygonWithHoles& island, const std::vector<Polyline>& axis);

}  // namespace slicefarm::infill
