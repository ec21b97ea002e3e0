#pragma once

#include <span>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm {

/// Which points of a set of rings count as inside.
enum class FillRule {
  kNonZero,   ///< winding number is not 0
  kEvenOdd,   ///< winding number is odd
  kPositive,  ///< winding number is above 0
};

/// The region that `rings` enclose under `rule`, as disjoint islands in canonical form.
/// Points of intersection are rounded to nm; slivers under 1 nm vanish. Cost: O((n + k) log n), k
/// crossings.
MultiPolygon Union(std::span<const Polygon> rings, FillRule rule);
MultiPolygon Union(const MultiPolygon& a, const MultiPolygon& b);
MultiPolygon Difference(const MultiPolygon& a, const MultiPolygon& b);
MultiPolygon Intersection(const MultiPolygon& a, const MultiPolygon& b);

/// The region that at least `count` of the `regions` cover, in one sweep. REQUIRES: 1 <= count.
/// With count = regions.size() this is the intersection of all.
MultiPolygon CoveredAtLeast(std::span<const MultiPolygon* const> regions, int count);

/// `subject` less CoveredAtLeast(regions, count), in one sweep.
MultiPolygon DifferenceCovered(const MultiPolygon& subject,
                               std::span<const MultiPolygon* const> regions, int count);

/// The parts of open `lines` inside `clip`. Order and direction of the parts are unspecified but
/// deterministic.
std::vector<Polyline> ClipLines(std::span<const Polyline> lines, const MultiPolygon& clip);

}  // namespace slicefarm
