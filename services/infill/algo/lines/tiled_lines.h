#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "services/infill/algo/lines/clip_curves.h"
#include "services/infill/algo/lines/level_lines.h"
#include "services/infill/algo/lines/scan_lines.h"

namespace slicefarm::infill {

/// Straight segments in place of smooth level lines, as long as `tolerance` allows, in the lines'
/// own unit. Corners lie a third of a chord's rise outside of the line, so that the length stays
/// what it is. The same at both ends of an open line, which goes on.
LevelLine WithLongSegments(const LevelLine& line, double tolerance);

/// The lines of all periods that come near a region, in a frame around the origin in which a period
/// is `period_nm` long. Errors: as CheckLineCount.
absl::StatusOr<std::vector<Curve>> TiledLines(const MultiPolygon& region,
                                              std::span<const LevelLine> lines,
                                              const LineAxes& frame, double period_nm);

}  // namespace slicefarm::infill
