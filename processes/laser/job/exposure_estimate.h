#pragma once

#include "common/stage/stages.h"
#include "services/coordinator/algo/pipeline/job_process.h"

namespace slicefarm {
struct ExposureSettings;
}  // namespace slicefarm

namespace slicefarm::coordinator {

/// What scanning will take, from areas and perimeters alone: each area by hatch distance and speed,
/// each contour by its speed, and recoating before each layer. Jumps and delays are left out; there
/// is no filament. Cost: O(points).
JobEstimate EstimateExposure(const SlicedOutlines& job, const ExposureSettings& settings);

}  // namespace slicefarm::coordinator
