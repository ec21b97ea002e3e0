#pragma once

#include <optional>
#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/polygon.h"

namespace slicefarm::slicing {

/// Returns Union(loops, rule) for loops that do not touch each other or themselves, such as the
/// loops of a mesh without defects. These loops need no clipping: only the holes are assigned to
/// islands. Returns nullopt if two edges meet anywhere but at their common corner, or if the check
/// would take too long. The caller then uses Union.
///
/// A sweep by x tests each edge against the edges that overlap its x-range. At the first corner of
/// each loop, it sums the winding number of the edges below. All tests are exact. REQUIRES: each
/// loop is a CleanedRing, coordinates within 32 bits. The result is in canonical form. Cost: O(n a)
/// for n edges, if a vertical line crosses at most a of them; limited to 400 n.
std::optional<MultiPolygon> NestSimpleLoops(const std::vector<Polygon>& loops, FillRule rule);

}  // namespace slicefarm::slicing
