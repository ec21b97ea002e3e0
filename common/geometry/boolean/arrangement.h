#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::internal {

// Region in which rings in general position have at least a given winding number; private to
// common/geometry.

/// A ring of an arrangement. Rings with the same number in `group` do not meet each other or
/// themselves, and are not tested against each other. Rings of group kMayMeetAny are tested against
/// all rings.
struct GroupedRing {
  static constexpr int kMayMeetAny = -1;

  Polygon points;
  int group = kMayMeetAny;
};

/// Returns the points with winding number `least` or more, as islands. Returns nullopt in these
/// cases:
/// - The rings are not in general position: one passes through a corner of another, touches it, or
///   overlaps its edge.
/// - The result is uncertain.
/// - So many rings or edges are side by side that the calculation would take long.
///
/// The algorithm cuts rings where they cross. It determines the winding number to the left of each
/// ring once along a ray, and then updates it from crossing to crossing. The parts of rings with
/// winding number `least` on their left are joined into the rings of the result. Crossings are
/// found exactly; their positions are rounded to nm. Cost: O(n log n), n edges, plus the edges to
/// the right of each ring's start, plus the pairs of edges that overlap in x or in y, whichever are
/// fewer.
std::optional<MultiPolygon> TryWindingRegion(std::span<const GroupedRing> rings, int least);

/// An edge of a ring.
struct TracedEdge {
  int32_t ring = 0;
  int32_t index = 0;
};

/// A ring around the region. `edges[i]` is the edge of a given ring on which the part from
/// `points[i]` to the next point is.
struct TracedRing {
  Polygon points;
  std::vector<TracedEdge> edges;
};

/// Returns the rings around the region of TryWindingRegion, and where they come from. Cost and
/// errors: as TryWindingRegion.
std::optional<std::vector<TracedRing>> TryWindingRings(std::span<const GroupedRing> rings,
                                                       int least);

}  // namespace slicefarm::internal
