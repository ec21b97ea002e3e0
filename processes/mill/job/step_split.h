#pragma once

#include <span>
#include <vector>

#include "common/base/shared/shared.h"
#include "processes/mill/model/milled_program.h"
#include "processes/mill/task/mill_task.h"

namespace slicefarm::coordinator {

/// Cuts the steps of a job into tasks for `slots` workers. Each task has steps of one phase.
/// Adjacent levels share most of their work, so each phase is cut into at most two ranges per slot.
/// The weight of a range is limited, so that a failed worker does not lose too much work. The
/// results of the steps do not depend on the cuts.
///
/// Result: the ranges contain all steps in order, and none is empty. Cost: O(steps).
std::vector<MillTask> SplitSteps(const MillLayout& layout, const Shared<MillInput>& input,
                                 int slots);

}  // namespace slicefarm::coordinator
