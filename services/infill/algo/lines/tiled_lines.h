#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "services/infill/algo/lines/clip_curves.h"
#include "services/infill/algo/lines/level_lines.h"
#include "services/infill/algo/lines/scan_lines.h"

namespace slicefarm::infill {

/// Replaces a smooth level line (level_lines.h) by straight segments that are as long as
/// `tolerance` allows. The tolerance has the unit of the line's points. Corners are moved outwards
/// by a third of the height of their arcs over the chords, so that the length of the line does not
/// change. Both ends of an open line are moved equally, because the line continues there.
LevelLine WithLongSegments(const LevelLine& line, double tolerance);

/// Returns all repetitions of level lines near a region, not yet cut to it. `lines` repeat with
/// period 1, which is `period_nm` in the plane; `frame` is a frame around the origin. Errors:
/// REQUEST_TOO_LARGE for more lines than limits::kMaxLinesPerFill.
absl::StatusOr<std::vector<Curve>> TiledLines(const MultiPolygon& region,
                                              std::span<const LevelLine> lines,
                                              const LineAxes& frame, double period_nm);

}  // namespace slicefarm::infill
