#pragma once

#include <span>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/milling/algo/drop/drop_cutter.h"
#include "services/milling/algo/motion/move_builder.h"
#include "services/milling/algo/strategy/mill_steps.h"

namespace slicefarm::milling {

/// Cuts the runs of rest areas from the first row on, always the nearest end next: along the
/// surface from one run to the next where they are near, else by rapid moves above the stock. Runs
/// that meet no stock are left out. The result: how many were cut. Errors: Cancelled. Cost: O(n^2)
/// for n runs, at 1 ns.
absl::StatusOr<int> CutRest(const MillingJob& job, std::span<const MilledStep> rows,
                            MoveBuilder& moves, const CancelToken& cancel);

}  // namespace slicefarm::milling
