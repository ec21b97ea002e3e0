#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::infill {

/// Returns one straight line (spoke) for each ring of the island that no end of the main axis
/// reaches: from the ring's point nearest to the axis to the axis.
///
/// An axis ends before a round end of the island, and passes around a hole. Lines at even distances
/// from the axis would be rings there, without contact to a wall. With the spokes, every ring of
/// the island is reached. Cost: O(n m), n points of the island, m points of the axis. REQUIRES: the
/// axis has at least one line.
std::vector<Polyline> AxisSpokes(const PolygonWithHoles& island, const std::vector<Polyline>& axis);

}  // namespace slicefarm::infill
