#pragma once

#include "common/geometry/polygon.h"

namespace slicefarm {

/// Returns a region with all holes filled. Islands inside of holes become part of the filled area.
/// Cost: O(n) if the region has no holes, else that of a Union.
MultiPolygon WithoutHoles(const MultiPolygon& region);

}  // namespace slicefarm
