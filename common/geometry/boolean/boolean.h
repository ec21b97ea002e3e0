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
/// n edges and k crossings.
MultiPolygon Union(std::span<const Polygon> rings, FillRule rule);
/// Returns the union of two regions. Form, rounding and cost: see the union of rings.
MultiPolygon Union(const MultiPolygon& a, const MultiPolygon& b);
/// Returns region a minus region b. Form, rounding and cost: see the union of rings.
MultiPolygon Difference(const MultiPolygon& a, const MultiPolygon& b);
/// Returns the intersection of two regions. Form, rounding and cost: see the union of rings.
MultiPolygon Intersection(const MultiPolygon& a, const MultiPolygon& b);

}  // namespace slicefarm
