#pragma once

#include "common/model/layers/job_plan.h"
#include "common/model/layers/layer.h"
#include "services/ordering/algo/tours/work_budget.h"

namespace slicefarm::ordering {

/// Leads the ways between a layer's visits off what has curled up, on the copies that they come
/// from, go to, and pass. `sights`: lines of sight that may be looked at. Cost: O(visits^2) boxes.
void KeepOffCurled(const LayerPlan& plan, WorkBudget& sights, OrderedLayer& layer);

}  // namespace slicefarm::ordering
