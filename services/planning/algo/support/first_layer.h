#pragma once

#include "services/planning/algo/support/clearance.h"
#include "services/planning/algo/support/support_plan.h"

namespace slicefarm::planning {

/// Grows what stands on the bed by `by_nm` to the sides, so that it holds, as far as the place is
/// free. It grows in steps, each from what the last one left, so it goes round walls and never
/// through them. Interfaces keep their outlines. REQUIRES: layer.first.
/// Cost: an offset and a boolean operation for each width_nm of by_nm.
void GrowFirstLayer(Coord by_nm, Coord width_nm, const Clearance& clearance, SupportLayer& layer);

}  // namespace slicefarm::planning
