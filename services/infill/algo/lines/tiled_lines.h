#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "services/infill/algo/lines/clip_curves.h"
#include "services/infill/algo/lines/level_lines.h"
#include "services/infill/algo/lines/scan_lines.h"

namespace slicefarm::infill {

/// Replaces smooth level lines by straight segments that are as long as `tolerance` allows, in the
/// lines' own unit. Corners are a third of a chord's rise outside of the line, so that the length
/// does not change. Both ends of an open line are treated in the same manner, because the line
/// continues there.
LevelLine WithLongSegments(const LevelLine& line, double tolerance);

/// Returns the lines of all periods near a region. The frame is around the origin, and a period is
/// `period_nm` long. Errors: as CheckLineCount.
absl::StatusOr<std::vector<Curve>> TiledLines(const MultiPolygon& region,
                                              std::span<const LevelLine> lines,
                                              const LineAxes& frame, double period_nm);

}  // namespace slicefarm::infill
