#pragma once

#include "common/stage/stages.h"
#include "services/coordinator/algo/pipeline/job_process.h"

namespace slicefarm {
struct ExposureSettings;
}  // namespace slicefarm

namespace slicefarm::coordinator {

/// Estimates the scanning time from areas and perimeters alone. Areas count with the hatch distance
/// and speed, contours with their speed, and each layer with its recoating time. Jumps and delays
/// are left out, and there is no filament. Cost: O(points).
JobEstimate EstimateExposure(const SlicedOutlines& job, const ExposureSettings& settings);

}  // namespace slicefarm::coordinator
