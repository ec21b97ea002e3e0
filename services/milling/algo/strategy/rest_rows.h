#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/milling/algo/strategy/milling_job.h"

namespace slicefarm::milling {

/// Returns the runs for parallel finishing of rest areas (the flat parts of the surface), per row.
/// A run consists of the samples where the surface of tip positions (DropCutter) is flatter than
/// rest_angle_deg, and one more sample at each end. Points are inserted between two samples until
/// the tip's path deviates from the surface by at most a tenth of the tolerance. A row depends only
/// on its own y. Errors: Cancelled. Cost: three drops per sample.
absl::StatusOr<std::vector<std::vector<RestRun>>> RestRows(const MillingJob& job,
                                                           std::span<const double> rows_mm,
                                                           const CancelToken& cancel,
                                                           int threads = 1);

}  // namespace slicefarm::milling
