#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/milling/algo/strategy/level_passes.h"
#include "services/milling/algo/strategy/milling_job.h"
#include "services/milling/algo/strategy/rest_rows.h"

namespace slicefarm::milling {

/// Returns the passes of the steps [first, last) of a job. A step's passes depend neither on the
/// other steps of the range nor on the number of threads. REQUIRES: first <= last <=
/// job.steps.size(). Errors: any error of Waterlines; Cancelled.
absl::StatusOr<std::vector<MilledStep>> MillSteps(const MillingJob& job, size_t first, size_t last,
                                                  const CancelToken& cancel = {}, int threads = 1);

}  // namespace slicefarm::milling
