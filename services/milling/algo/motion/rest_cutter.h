#pragma once

#include <span>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/milling/algo/drop/drop_cutter.h"
#include "services/milling/algo/motion/move_builder.h"
#include "services/milling/algo/strategy/mill_steps.h"

namespace slicefarm::milling {

/// Cuts the runs of rest areas: lines on flat parts of the surface that level passes leave rough
/// (RestRun). Begins with the first row, then always continues at the nearest end of a run. If the
/// end is close, the tip moves there along the surface, otherwise by rapid moves above the stock.
/// Parts of runs that meet no stock are left out. Returns the number of runs cut. Errors:
/// Cancelled. Cost: O(n^2) for n runs, at 1 ns.
absl::StatusOr<int> CutRest(const MillingJob& job, std::span<const MilledStep> rows,
                            MoveBuilder& moves, const CancelToken& cancel);

}  // namespace slicefarm::milling
