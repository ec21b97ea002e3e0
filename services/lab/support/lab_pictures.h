#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "services/planning/algo/support/support_plan.h"
#include "services/planning/algo/support/support_problem.h"

namespace slicefarm::lab {

/// PNG of one layer of support, with the part's layer that shares most height with it in grey.
/// Errors: Internal if the picture cannot be made.
absl::StatusOr<std::string> DrawSupportLayer(const planning::SupportProblem& problem,
                                             const planning::SupportPlan& plan, size_t layer);

/// PNG of all, seen from the front (or from the right): supports in front of the part.
absl::StatusOr<std::string> DrawSupportView(const planning::SupportProblem& problem,
                                            const planning::SupportPlan& plan, bool from_right);

}  // namespace slicefarm::lab
