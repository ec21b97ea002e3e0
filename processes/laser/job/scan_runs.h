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

/// OUT_OF_BUILD_VOLUME, naming the setting, if the scanner may leave the bed where it runs on
/// beyond lines with the laser off (skywriting, contour_run): what is exposed must lie as far from
/// the bed's edge as the longest run. `exposed`: on the plate.
absl::Status CheckRuns(const ExposureSettings& settings, const Polygon& bed, const Box& exposed);

/// The same before anything is scanned, by the outermost contours; thin walls are left out.
/// Cost: O(points), and an offset of each outline if it fails.
absl::Status CheckRuns(const ExposureSettings& settings, const Polygon& bed,
                       const SlicedOutlines& job);

}  // namespace slicefarm::coordinator
