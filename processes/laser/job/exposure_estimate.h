#pragma once

#include "common/stage/stages.h"
#include "processes/fdm/job/print_estimate.h"

namespace slicefarm::coordinator {

/// What scanning will take, from areas and perimeters alone: each area by hatch distance and speed,
/// each contour by its speed. Jumps, delays and the recoater are left out; there is no filament.
/// Cost: O(points).
PrintEstimate EstimateExposure(const SlicedOutlines& job, const ExposureSettings& settings);

}  // namespace slicefarm::coordinator
