#pragma once

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/geometry/polygon.h"

namespace slicefarm::exposure {

/// Lines along the middle of what is thinner than 2 * `inset_nm`, so that an inset leaves nothing
/// of it: one exposure for a thin wall. Corners are no thin walls: what is shorter than it is wide
/// is left out. Lines that meet are one. Errors: those of Decompose.
absl::StatusOr<std::vector<Polyline>> ThinWallLines(const MultiPolygon& outline, Coord inset_nm,
                                                    const CancelToken& cancel);

}  // namespace slicefarm::exposure
