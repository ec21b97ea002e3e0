#pragma once

#include <vector>

#include "absl/status/status.h"
#include "common/geometry/polygon.h"
#include "services/infill/algo/space_filling/ring_links.h"

namespace slicefarm::infill {

/// Returns the edge of a region as step 0, and the lines k spacings inside it as step k, sorted by
/// step. If the region is half a spacing smaller than the area to be filled, the lines fill this
/// area. Their length times the spacing is its area by the midpoint rule, with an error of either
/// sign where lines from two sides meet.
///
/// Corners are mitered. Rings shorter than one and a half spacings are omitted: a line covers their
/// inside. Beyond step 0, narrow parts are also omitted where a line's two sides would be nearer to
/// each other than a tenth of a spacing. REQUIRES: spacing_nm > 0. Cost: an offset for each step.
std::vector<StepRing> RingsFrom(MultiPolygon region, Coord spacing_nm);

/// Returns the depth of the first line of a fill inside an edge: `first_line` spacings.
inline Coord FirstLineDepth(double first_line, Coord spacing_nm) {
  return static_cast<Coord>(first_line * static_cast<double>(spacing_nm));
}

/// Returns errors of fills with lines a spacing apart: InvalidArgument (SETTING_OUT_OF_RANGE)
/// unless the spacing is positive; LimitError (REQUEST_TOO_LARGE) if the region's box has more
/// squares of a spacing than limits::kMaxPointsPerLayer.
absl::Status CheckRingSpacing(const PolygonWithHoles& region, Coord spacing_nm);

}  // namespace slicefarm::infill
