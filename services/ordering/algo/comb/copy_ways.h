#pragma once

#include "common/model/layers/job_plan.h"
#include "common/model/layers/layer.h"
#include "services/ordering/algo/tours/work_budget.h"

namespace slicefarm::ordering {

/// Leads the travels between a layer's visits around curled areas on the copies that they leave,
/// reach and pass. `sights`: number of lines of sight that may be computed. Cost: O(visits^2)
/// boxes.
void KeepOffCurled(const LayerPlan& plan, WorkBudget& sights, OrderedLayer& layer);

}  // namespace slicefarm::ordering
