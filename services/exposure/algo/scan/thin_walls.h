#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/geometry/polygon.h"
#include "services/exposure/algo/scan/inside.h"

namespace slicefarm::exposure {

/// Returns the parts of an outline that disappear in an inset by `depth_nm`. Corners also disappear
/// in the inset, but are not returned. Cost: about two offsets and a difference for islands with
/// narrow parts, a tenth of an offset for other islands.
MultiPolygon NarrowParts(const MultiPolygon& outline, Coord depth_nm);

/// Returns lines along the middle of thin walls. A thin wall is an area that the lines along the
/// outline (`levels`) leave unmelted: it is thinner than the first contour, or is between two
/// contours without space for a third one. An area shorter than it is wide is a corner and is
/// omitted. Each thin wall is exposed once. Lines that meet are joined. The lines keep 1 um from
/// the boundary of the area that they melt. `narrow`: result of NarrowParts for the outline, with
/// at least the depth of the last level. Errors: Cancelled; REQUEST_MALFORMED (Decompose).
absl::StatusOr<std::vector<Polyline>> MiddleLines(const MultiPolygon& outline,
                                                  const MultiPolygon& narrow,
                                                  std::span<const LineLevel> levels,
                                                  const CancelToken& cancel);

}  // namespace slicefarm::exposure
