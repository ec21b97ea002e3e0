#pragma once

#include <span>
#include <vector>

#include "common/base/shared/shared.h"
#include "processes/mill/model/milled_program.h"
#include "processes/mill/task/mill_task.h"

namespace slicefarm::coordinator {

/// Cuts a job's steps into tasks for `slots` workers, each of one phase. Levels share most of their
/// work with those beside them, so each phase is cut into two ranges a slot at most; a range weighs
/// no more than a worker's loss is worth. What comes of the steps does not depend on the cut.
///
/// Shapes: the ranges cover all steps in order, none is empty. Cost: O(steps).
std::vector<MillTask> SplitSteps(const MillLayout& layout, const Shared<MillInput>& input,
                                 int slots);

}  // namespace slicefarm::coordinator
