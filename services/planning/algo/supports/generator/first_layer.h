#pragma once

#include "services/planning/algo/supports/generator/clearance.h"
#include "services/planning/algo/supports/generator/support_plan.h"

namespace slicefarm::planning {

/// Widens the supports on the bed by `by_nm`, as far as the bed is free, so that they adhere. Each
/// outline grows in steps of `width_nm`. After each step it is cut to the free area, so it grows
/// around walls and never through them. Interfaces do not grow. REQUIRES: layer.first. Cost: an
/// offset and a boolean operation for each step.
void GrowFirstLayer(Coord by_nm, Coord width_nm, const Clearance& clearance, SupportLayer& layer);

}  // namespace slicefarm::planning
