#pragma once

#include <span>

#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"

namespace slicefarm {

/// Returns the region with a non-zero winding number of `subject`, minus the region with a non-zero
/// winding number of `rings`. Rings may cross and overlap, so one sweep can handle the outlines of
/// many regions. The result is in canonical form. Cost: O((n + k) log n) for n edges and k
/// crossings.
MultiPolygon WithoutRings(std::span<const Polygon> subject, std::span<const Polygon> rings);
/// Returns `region` minus the region with a non-zero winding number of `rings`, in canonical form.
MultiPolygon WithoutRings(const MultiPolygon& region, std::span<const Polygon> rings);

/// Appends the rings of `region` that can affect `box` to `rings`, with the same winding numbers
/// inside the box. A sequence of points that are all beyond the same side of the box is replaced by
/// its two ends. Outside the box, the appended rings are therefore meaningless. Cost: O(n), n
/// points.
void AppendRingsNear(const MultiPolygon& region, const Box& box, std::vector<Polygon>& rings);

}  // namespace slicefarm
