#pragma once

#include <span>

#include "common/geometry/polygon.h"

namespace slicefarm {

/// True if it is proven that no two edges of the rings cross, touch or overlap, other than
/// neighbours in the corner they share. Rings of fewer than three points, repeated points and
/// spikes are not simple. Exact; but false as well for rings whose edges lie beside each other by
/// the thousand in both directions, which would take too long. Cost: O(n log n) and the pairs of
/// edges that overlap in x or in y, whichever are fewer.
bool AreSimple(std::span<const Polygon* const> rings);

}  // namespace slicefarm
