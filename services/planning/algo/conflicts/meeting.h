#pragma once

#include <optional>
#include <string>

#include "absl/status/status.h"
#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// What two have in common may be so wide: solids that touch in a drawing are off by as much, and
/// beads have room for it.
inline constexpr Coord kSharedWidthNm = 100'000;

/// A point in what both cover, where that is wider than kSharedWidthNm. Cost: a boolean operation if
/// their boxes meet.
std::optional<Point> MeetingOf(const MultiPolygon& a, const MultiPolygon& b);

/// PATHS_CONFLICT, INVALID_ARGUMENT: metadata `first`, `second`, `x_mm`, `y_mm`, `z_mm`.
absl::Status ConflictError(const std::string& first, const std::string& second, Point place,
                           Coord z_nm);

}  // namespace slicefarm::planning
