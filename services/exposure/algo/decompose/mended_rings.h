#pragma once

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"

namespace slicefarm::exposure {

/// The same region by rings of which every corner's inside is its own: where rings touch in a
/// corner they pass it without crossing, where a corner touches an edge the edge has a corner
/// there, and where two rings run along each other with nothing between both edges are gone. What
/// touches nothing comes back as it was.
///
/// Errors: REQUEST_MALFORMED, with the place, if edges cross, lie on each other the same way round,
///         a ring is turned the wrong way, or an island lies in another one. Exact.
/// Cost:   O(n log n), and the pairs of edges that overlap in x where anything touches.
absl::StatusOr<MultiPolygon> MendedRings(MultiPolygon islands);

}  // namespace slicefarm::exposure
