#pragma once

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"

namespace slicefarm::exposure {

/// Returns the same region as rings that may touch but never cross or overlap, so that the inside
/// is clear at each corner. Where rings touch in a corner, they pass the corner without crossing.
/// Where a corner touches an edge, the edge gets a corner. Where two rings share an edge with no
/// area between them, both edges are removed. A ring that touches nothing is unchanged.
///
/// Errors: REQUEST_MALFORMED, with the position, if edges cross, if edges of the same direction
/// overlap, if a ring has the wrong direction, or if an island is inside another island. Exact.
/// Cost: O(n log n), n edges. If rings touch, the number of pairs of edges that overlap in x is
/// added.
absl::StatusOr<MultiPolygon> MendedRings(MultiPolygon islands);

}  // namespace slicefarm::exposure
