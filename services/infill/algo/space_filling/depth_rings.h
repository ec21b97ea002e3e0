#pragma once

#include <vector>

#include "absl/status/status.h"
#include "common/geometry/polygon.h"
#include "services/infill/algo/space_filling/ring_links.h"

namespace slicefarm::infill {

/// Returns the boundary of a region as step 0, and the lines k spacings inside it as step k, sorted
/// by step. `region`: the area that the lines have to fill, inset by half a spacing. The length of
/// the lines times the spacing approximates this area (midpoint rule). Where lines from two sides
/// meet, the error may have either sign.
///
/// Corners are mitered. Rings shorter than one and a half spacings are omitted, because a line
/// covers the area inside them. Beyond step 0, parts of lines are omitted where two sides of a line
/// would be nearer to each other than a tenth of a spacing. REQUIRES: spacing_nm > 0. Cost: an
/// offset for each step.
std::vector<StepRing> RingsFrom(MultiPolygon region, Coord spacing_nm);

/// Returns the distance of a fill's first line from the boundary, in nm. `first_line`: the same
/// distance in spacings.
inline Coord FirstLineDepth(double first_line, Coord spacing_nm) {
  return static_cast<Coord>(first_line * static_cast<double>(spacing_nm));
}

/// Checks the spacing of a fill. Errors: InvalidArgument (SETTING_OUT_OF_RANGE) if it is not
/// positive; LimitError (REQUEST_TOO_LARGE) if the region's bounding box has more than
/// limits::kMaxPointsPerLayer squares with this side.
absl::Status CheckRingSpacing(const PolygonWithHoles& region, Coord spacing_nm);

}  // namespace slicefarm::infill
