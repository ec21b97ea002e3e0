#pragma once

#include <span>

#include "common/geometry/polygon.h"

namespace slicefarm {

/// Returns true if it is certain that no two edges of the rings cross, touch or overlap, except
/// neighbours at their common corner. Rings with fewer than three points, repeated points or spikes
/// are not simple. The test is exact. If thousands of edges are side by side in both directions,
/// the test would take too long, and the function returns false. Cost: O(n log n), n edges, plus
/// the pairs of edges that overlap in x or in y, whichever are fewer.
bool AreSimple(std::span<const Polygon* const> rings);

}  // namespace slicefarm
