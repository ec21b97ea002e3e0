#pragma once

#include <optional>
#include <string>

#include "absl/status/status.h"
#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// Largest width of a harmless overlap, in nm. Solids that touch in a drawing overlap by this much
/// when they are sliced, and their beads still fit.
inline constexpr Coord kSharedWidthNm = 100'000;

/// Returns a point of the common area where it is wider than kSharedWidthNm. Cost: one boolean
/// operation if the boxes meet.
std::optional<Point> MeetingOf(const MultiPolygon& a, const MultiPolygon& b);

/// Returns PATHS_CONFLICT, INVALID_ARGUMENT, with metadata `first`, `second`, `x_mm`, `y_mm`,
/// `z_mm`.
absl::Status ConflictError(const std::string& first, const std::string& second, Point place,
                           Coord z_nm);

}  // namespace slicefarm::planning
