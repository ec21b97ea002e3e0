#pragma once

#include <span>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/milling/algo/drop/drop_cutter.h"
#include "services/milling/algo/motion/move_builder.h"
#include "services/milling/algo/strategy/mill_steps.h"

namespace slicefarm::milling {

/// Cuts the runs of rest areas. It begins with the first row and always continues with the nearest
/// end of a run. Runs close to each other are connected along the surface, others by rapid moves
/// above the stock. Parts of runs that meet no stock are left out. Returns the number of runs cut.
/// Errors: Cancelled. Cost: O(n^2) for n runs, at 1 ns.
absl::StatusOr<int> CutRest(const MillingJob& job, std::span<const MilledStep> rows,
                            MoveBuilder& moves, const CancelToken& cancel);

}  // namespace slicefarm::milling
