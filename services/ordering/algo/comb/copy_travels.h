#pragma once

#include "common/model/layers/job_plan.h"
#include "common/model/layers/layer.h"
#include "services/ordering/algo/tours/work_budget.h"

namespace slicefarm::ordering {

/// Leads a layer's travels between visits (copies of a block) around curled areas. A travel avoids
/// the curled areas of the copy where it starts, of the copy where it ends, and of all copies
/// between them. `sights`: number of lines of sight that may be computed. Cost: O(visits^2)
/// comparisons of boxes.
void KeepOffCurled(const LayerPlan& plan, WorkBudget& sights, OrderedLayer& layer);

}  // namespace slicefarm::ordering
