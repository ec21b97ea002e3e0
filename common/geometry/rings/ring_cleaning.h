#pragma once

#include "common/geometry/polygon.h"

namespace slicefarm {

/// The ring without repeated points, points in the middle of straight lines and spikes of no width;
/// exact. Empty if nothing is left. Any three consecutive points of the result make a true corner.
/// Cost: O(n).
Polygon CleanedRing(const Polygon& ring);

}  // namespace slicefarm
