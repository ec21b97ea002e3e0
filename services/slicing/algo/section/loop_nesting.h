#pragma once

#include <optional>
#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/polygon.h"

namespace slicefarm::slicing {

/// Union(loops, rule) for loops that do not touch each other or themselves, which is what a sound
/// mesh gives: they need no clipping, only to be nested. Nothing if any two edges meet elsewhere
/// than at their common corner, or if finding out would take too long; Union is the way then.
///
/// A sweep over the edges by x tests each against those that its x-range overlaps and, at the first
/// corner of each loop, sums the winding number of the edges below it. All tests are exact.
/// REQUIRES: each loop is a CleanedRing, coordinates within 32 bits. The result is in canonical
/// form. Cost: O(n a) for n edges of which a overlap a vertical line, at most 400 n.
std::optional<MultiPolygon> NestSimpleLoops(const std::vector<Polygon>& loops, FillRule rule);

}  // namespace slicefarm::slicing
