#pragma once

#include <span>

#include "absl/status/status.h"
#include "common/geometry/measure.h"
#include "common/model/layers/layer.h"
#include "common/stage/slicing_stage.h"
#include "common/stage/stages.h"

namespace slicefarm {
struct ExposureSettings;
}  // namespace slicefarm

namespace slicefarm::coordinator {

/// Checks that the scanner stays on the bed when it moves beyond the ends of lines with the laser
/// off (skywriting, contour_run). The distance of the exposed area from the boundary of the bed
/// must be at least the longest of these moves. Returns OUT_OF_BUILD_VOLUME, with the setting, if
/// the distance is smaller. `exposed`: bounding box of the exposed area on the plate.
absl::Status CheckRuns(const ExposureSettings& settings, const Polygon& bed, const Box& exposed);

/// Makes the same check before anything is scanned, with the outermost contours as the exposed
/// area. Ignores thin walls. Cost: O(points), and an offset of each outline if the check with
/// unshrunk outlines fails.
absl::Status CheckRuns(const ExposureSettings& settings, const Polygon& bed,
                       const SlicedOutlines& job);

}  // namespace slicefarm::coordinator
