#pragma once

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "processes/mill/model/mill_report.h"
#include "services/milling/algo/motion/mill_program.h"

namespace slicefarm::milling {

/// Sums a program and checks it against the part: exactly, by the drop cutter, for the cutter less
/// the tolerance on all sides. Errors: Cancelled. Cost: a drop for each place, on all threads.
absl::StatusOr<MillReport> ReportOf(const MillingJob& job, const MillProgram& program,
                                    const CancelToken& cancel = {}, int threads = 1);

}  // namespace slicefarm::milling
