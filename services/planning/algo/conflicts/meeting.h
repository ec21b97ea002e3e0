#pragma once

#include <optional>
#include <string>

#include "absl/status/status.h"
#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// Largest width of an overlap that counts as harmless, in nm. Solids that touch in a drawing
/// overlap by this much when they are sliced, and their beads still fit.
inline constexpr Coord kSharedWidthNm = 100'000;

/// Returns a point of the common area of `a` and `b` where this area is wider than kSharedWidthNm;
/// nullopt if it is nowhere so wide. Cost: one boolean operation if the boxes meet.
std::optional<Point> MeetingOf(const MultiPolygon& a, const MultiPolygon& b);

/// Returns the error PATHS_CONFLICT (INVALID_ARGUMENT) for two structures that overlap at `place`
/// and at the height `z_nm` above the bed. `first`, `second`: names of the structures. Metadata:
/// `first`, `second`, `x_mm`, `y_mm`, `z_mm`.
absl::Status ConflictError(const std::string& first, const std::string& second, Point place,
                           Coord z_nm);

}  // namespace slicefarm::planning
