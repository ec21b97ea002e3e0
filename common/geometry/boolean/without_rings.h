#pragma once

#include <span>

#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"

namespace slicefarm {

/// All that `subject` winds around (winding number not 0), less all that `rings` do. Each may cross
/// and overlap: outlines of many regions in one sweep. The result is in canonical form.
/// Cost: O((n + k) log n), k crossings.
MultiPolygon WithoutRings(std::span<const Polygon> subject, std::span<const Polygon> rings);
MultiPolygon WithoutRings(const MultiPolygon& region, std::span<const Polygon> rings);

/// Adds the rings of `region` that can matter inside `box`, with winding numbers there as they
/// were: stretches that lie beyond one side of the box are replaced by a line, so what is outside
/// means nothing. Cost: O(n).
void AppendRingsNear(const MultiPolygon& region, const Box& box, std::vector<Polygon>& rings);

}  // namespace slicefarm
