#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "services/planning/algo/supports/generator/support_plan.h"
#include "services/planning/algo/supports/generator/support_problem.h"

namespace slicefarm::lab {

/// Returns a PNG of one support layer. The part's layer with the largest common height range is
/// drawn in grey. Errors: Internal if the picture cannot be made.
absl::StatusOr<std::string> DrawSupportLayer(const planning::SupportProblem& problem,
                                             const planning::SupportPlan& plan, size_t layer);

/// Returns a PNG of the whole model, seen from the front or from the right. Supports are drawn in
/// front of the part.
absl::StatusOr<std::string> DrawSupportView(const planning::SupportProblem& problem,
                                            const planning::SupportPlan& plan, bool from_right);

}  // namespace slicefarm::lab
