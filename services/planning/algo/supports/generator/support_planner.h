#pragma once

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/planning/algo/supports/generator/support_plan.h"
#include "services/planning/algo/supports/generator/support_problem.h"

namespace slicefarm {
struct SupportOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// Plans supports for one object and reports its unsupported overhangs.
///
/// Steps: overhangs (overhangs.h), heights (support_heights.h), then columns (columns.h) or
/// branches (branches.h), each cut to the free area (clearance.h), and interfaces (interfaces.h).
///
/// Guarantees:
/// - No region meets the part or another object, grown by the xy spacing, at a shared height.
/// - Tops are top_gap_nm below the overhang that they support, or lower (support_heights.h).
/// - Below every printed region there is the bed, the part, or support.
/// - No region leaves the bed.
/// - The result does not depend on `threads`.
///
/// Units: nm, in the problem's coordinates. Errors: Cancelled. Cost: 1 to 3 ms per layer of a part
/// with 500 points per layer. Memory: see ReachField.
absl::StatusOr<SupportPlan> PlanSupports(const SupportProblem& problem,
                                         const SupportOptions& options, int threads,
                                         const CancelToken& cancel);

/// Returns a finding (kStartsInAir) for each island of a layer that does not touch the layer below,
/// also if supports are off. Cost: O(points) per layer, and a boolean operation where boxes meet.
std::vector<SupportFinding> IslandsInAir(const SupportProblem& problem, int threads,
                                         const CancelToken& cancel);

}  // namespace slicefarm::planning
