#pragma once

#include "common/model/layers/layer.h"
#include "common/model/options/tool_row.h"

namespace slicefarm::motion {

/// Returns true if the settings allow travels of the layer `frame` to rise: there are a lift and a
/// retraction, and the layer is between retract_lift_above and retract_lift_below.
bool LiftsIn(const RetractionOptions& retraction, const LayerFrame& frame);

/// Returns true if the nozzle rises for a travel after a bead. `first_layer`: the bead is in the
/// first layer; `top`: the bead is part of a top surface.
bool RisesAfter(LiftAfter after, bool first_layer, bool top);

/// Returns true if the travel to the start of a copy rises in the layer `frame`. The bead before
/// this travel is not known, so the function assumes that it is not part of a top surface.
bool LiftsToStart(const RetractionOptions& retraction, const LayerFrame& frame);

}  // namespace slicefarm::motion
