#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/geometry/polygon.h"
#include "services/exposure/algo/scan/inside.h"

namespace slicefarm::exposure {

/// The parts of an outline that an inset by `depth_nm` leaves nothing of, without its corners.
/// Cost: about two offsets and a difference of the islands that have any; of others a tenth of one.
MultiPolygon NarrowParts(const MultiPolygon& outline, Coord depth_nm);

/// Lines along the middle of what lines along the outline leave open: what is thinner than the
/// first contour, or lies between two contours that have no room for another, and so on. One
/// exposure for each such wall. Corners are no walls: what is shorter than it is wide is left out.
/// Lines that meet are one. They keep 1 um from the border of what they melt. `narrow`: the
/// outline's NarrowParts, to the deepest level at least. Errors: those of Decompose.
absl::StatusOr<std::vector<Polyline>> MiddleLines(const MultiPolygon& outline,
                                                  const MultiPolygon& narrow,
                                                  std::span<const LineLevel> levels,
                                                  const CancelToken& cancel);

}  // namespace slicefarm::exposure
