#pragma once

#include <span>

#include "common/geometry/polygon.h"

namespace slicefarm {

/// Rule that decides which points of a set of rings are inside.
enum class FillRule {
  kNonZero,   ///< winding number is not 0
  kEvenOdd,   ///< winding number is odd
  kPositive,  ///< winding number is above 0
};

/// Returns the region that `rings` enclose under `rule`, as disjoint islands in canonical form.
/// Points of intersection are rounded to nm; slivers under 1 nm vanish. Cost: O((n + k) log n) for
/// k crossings.
MultiPolygon Union(std::span<const Polygon> rings, FillRule rule);
/// Returns the union of two regions. Result and cost as above.
MultiPolygon Union(const MultiPolygon& a, const MultiPolygon& b);
/// Returns region a minus region b. Result and cost as above.
MultiPolygon Difference(const MultiPolygon& a, const MultiPolygon& b);
/// Returns the intersection of two regions. Result and cost as above.
MultiPolygon Intersection(const MultiPolygon& a, const MultiPolygon& b);

}  // namespace slicefarm
