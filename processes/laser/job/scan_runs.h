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

/// Checks that the scanner stays on the bed where it runs beyond lines with the laser off
/// (skywriting, contour_run). The exposed area must be at least the longest run away from the bed's
/// edge. Returns OUT_OF_BUILD_VOLUME, with the setting, if it is not. `exposed`: on the plate.
absl::Status CheckRuns(const ExposureSettings& settings, const Polygon& bed, const Box& exposed);

/// Checks the same before anything is scanned, from the outermost contours. Thin walls are left
/// out. Cost: O(points), and an offset of each outline if the first check fails.
absl::Status CheckRuns(const ExposureSettings& settings, const Polygon& bed,
                       const SlicedOutlines& job);

}  // namespace slicefarm::coordinator
