#pragma once

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/planning/algo/support/support_plan.h"
#include "services/planning/algo/support/support_problem.h"

namespace slicefarm {
struct SupportOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// Supports for one object, and what they leave uncarried.
///
/// Steps: overhangs (overhangs.h), heights (support_heights.h), then columns (columns.h) or
/// branches (branches.h), each cut to what is free (clearance.h), and interfaces (interfaces.h).
///
/// Guarantees: no region meets the part or another object, grown by the xy spacing where they share
/// a height; tops lie top_gap_nm below what they carry; all that is printed rests on the
/// bed, on the part, or on support below it; nothing leaves the bed. The result does not depend on
/// `threads`.
/// Units: nm, in the problem's coordinates.
/// Errors: Cancelled.
/// Cost: 1 to 3 ms a layer of a part with 500 points a layer; memory, see ReachField.
absl::StatusOr<SupportPlan> PlanSupports(const SupportProblem& problem,
                                         const SupportOptions& options, int threads,
                                         const CancelToken& cancel);

/// The islands of each layer that touch nothing of the layer below: told of even where no supports
/// are asked for. Cost: O(points) a layer, and a boolean operation where boxes meet.
std::vector<SupportFinding> IslandsInAir(const SupportProblem& problem, int threads,
                                         const CancelToken& cancel);

}  // namespace slicefarm::planning
