#pragma once

#include <vector>

#include "absl/status/status.h"
#include "common/geometry/polygon.h"
#include "services/infill/algo/space_filling/ring_links.h"

namespace slicefarm::infill {

/// Returns the boundary of a region as step 0, and the lines k spacings inside it as step k, sorted
/// by step. `region` is the inset by half a spacing of the area that the lines have to fill. Their
/// length times the spacing is this area by the midpoint rule, with an error of either sign where
/// lines from two sides meet.
///
/// Corners are mitered. Rings shorter than one and a half spacings are omitted: a line covers their
/// inside. Beyond step 0, narrow parts are also omitted where a line's two sides would be nearer to
/// each other than a tenth of a spacing. REQUIRES: spacing_nm > 0. Cost: an offset for each step.
std::vector<StepRing> RingsFrom(MultiPolygon region, Coord spacing_nm);

/// Returns the distance of a fill's first line from the boundary, in nm: `first_line` spacings.
inline Coord FirstLineDepth(double first_line, Coord spacing_nm) {
  return static_cast<Coord>(first_line * static_cast<double>(spacing_nm));
}

/// Checks the spacing of a fill. Errors: InvalidArgument (SETTING_OUT_OF_RANGE) if it is not
/// positive; LimitError (REQUEST_TOO_LARGE) if the region's bounding box has more than
/// limits::kMaxPointsPerLayer squares with this side.
absl::Status CheckRingSpacing(const PolygonWithHoles& region, Coord spacing_nm);

}  // namespace slicefarm::infill
