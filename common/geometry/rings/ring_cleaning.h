#pragma once

#include "common/geometry/polygon.h"

namespace slicefarm {

/// Returns the ring without repeated points, points in the middle of straight lines, and spikes of
/// no width; exact. Empty if nothing remains. Any three consecutive points of the result are a true
/// corner. Cost: O(n), n points.
Polygon CleanedRing(const Polygon& ring);

}  // namespace slicefarm
