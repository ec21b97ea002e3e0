#pragma once

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "processes/mill/model/mill_report.h"
#include "services/milling/algo/motion/mill_program.h"

namespace slicefarm::milling {

/// Computes the totals of a program and checks if it gouges the part. The check is exact: at each
/// position it lowers a cutter that is smaller by the tolerance on all sides (DropCutter). Errors:
/// Cancelled. Cost: a drop for each position, on all threads.
absl::StatusOr<MillReport> ReportOf(const MillingJob& job, const MillProgram& program,
                                    const CancelToken& cancel = {}, int threads = 1);

}  // namespace slicefarm::milling
