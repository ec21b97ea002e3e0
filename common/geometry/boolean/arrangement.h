#pragma once

#include <optional>
#include <span>

#include "common/geometry/polygon.h"

namespace slicefarm::internal {

/// The region around which rings in general position wind at least so many times; private to
/// common/geometry.

/// A ring of an arrangement. Rings of one group do not meet each other or themselves, and are not
/// tested for it; those of group kMayMeetAny are tested against all.
struct GroupedRing {
  static constexpr int kMayMeetAny = -1;

  Polygon points;
  int group = kMayMeetAny;
};

/// The points with winding number `least` or more, as islands. nullopt unless the rings are in
/// general position (none passes through a corner of another, touches it, or runs along it), where
/// there is any doubt, and where rings or their edges lie beside each other in such numbers that it
/// would take long.
///
/// Rings are cut where they cross; the winding number to the left of a ring is counted out once
/// along a ray and then kept up from crossing to crossing; the parts along which it is `least` are
/// joined to the result's rings. Crossings are found exactly; their places are rounded to nm. Cost:
/// O(n log n), the edges of the rings that lie to the right of each ring's start, and the pairs of
/// edges that overlap in x or in y, whichever are fewer.
std::optional<MultiPolygon> TryWindingRegion(std::span<const GroupedRing> rings, int least);

}  // namespace slicefarm::internal
