#pragma once

#include "common/stage/stages.h"
#include "services/coordinator/algo/pipeline/job_process.h"

namespace slicefarm::coordinator {

/// What scanning will take, from areas and perimeters alone: each area by hatch distance and speed,
/// each contour by its speed. Jumps, delays and the recoater are left out; there is no filament.
/// Cost: O(points).
JobEstimate EstimateExposure(const SlicedOutlines& job, const ExposureSettings& settings);

}  // namespace slicefarm::coordinator
