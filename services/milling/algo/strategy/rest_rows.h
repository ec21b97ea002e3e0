#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/milling/algo/strategy/milling_job.h"

namespace slicefarm::milling {

/// Parallel finishing of rest areas: by row, the runs where the surface on which the cutter rests
/// is flatter than the angle, with one sample more at each end. Between two samples points are put
/// in until the tip is within a tenth of the tolerance of where it rests. A row depends on its own
/// y only. Errors: Cancelled. Cost: three drops a sample.
absl::StatusOr<std::vector<std::vector<RestRun>>> RestRows(const MillingJob& job,
                                                           std::span<const double> rows_mm,
                                                           const CancelToken& cancel,
                                                           int threads = 1);

}  // namespace slicefarm::milling
