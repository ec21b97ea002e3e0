#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "services/infill/algo/lines/clip_curves.h"
#include "services/infill/algo/lines/level_lines.h"
#include "services/infill/algo/lines/scan_lines.h"

namespace slicefarm::infill {

/// Replaces a smooth level line by straight segments that are as long as `tolerance` allows. The
/// tolerance has the line's own unit. Corners are moved outwards by a third of the rise of their
/// chords, so that the length of the line does not change. Both ends of an open line are treated in
/// the same manner, because the line continues there.
LevelLine WithLongSegments(const LevelLine& line, double tolerance);

/// Returns the lines of all periods near a region. `lines` repeat with the period 1; a period is
/// `period_nm` long, in a frame around the origin. Errors: REQUEST_TOO_LARGE for more lines than
/// limits::kMaxLinesPerFill.
absl::StatusOr<std::vector<Curve>> TiledLines(const MultiPolygon& region,
                                              std::span<const LevelLine> lines,
                                              const LineAxes& frame, double period_nm);

}  // namespace slicefarm::infill
