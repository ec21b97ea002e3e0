#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/geometry/polygon.h"
#include "services/exposure/algo/scan/inside.h"

namespace slicefarm::exposure {

/// Returns the parts of an outline that disappear in an inset by `depth_nm`, except its corners.
/// Cost: about two offsets and a difference for islands with narrow parts, a tenth of an offset for
/// other islands.
MultiPolygon NarrowParts(const MultiPolygon& outline, Coord depth_nm);

/// Returns lines along the middle of the areas that lines along the outline leave unmelted.
/// Examples are an area thinner than the first contour, or an area between two contours without
/// space for a third one. Each such thin wall is exposed once. Corners are not walls: an area
/// shorter than it is wide is omitted. Lines that meet are joined. They keep 1 um from the boundary
/// of the area that they melt. `narrow`: the outline's NarrowParts, at least to the deepest level.
/// Errors: Cancelled; REQUEST_MALFORMED (Decompose).
absl::StatusOr<std::vector<Polyline>> MiddleLines(const MultiPolygon& outline,
                                                  const MultiPolygon& narrow,
                                                  std::span<const LineLevel> levels,
                                                  const CancelToken& cancel);

}  // namespace slicefarm::exposure
