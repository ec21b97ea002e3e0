#pragma once

#include "common/model/layers/layer.h"
#include "common/model/options/tool_row.h"

namespace slicefarm::motion {

/// Returns true if travels may rise in the layer `frame`.
bool LiftsIn(const RetractionOptions& retraction, const LayerFrame& frame);

/// Returns true if the nozzle rises for a travel after a bead. `first_layer`: the bead is in the
/// first layer; `top`: the bead is part of a top surface.
bool RisesAfter(LiftAfter after, bool first_layer, bool top);

/// Returns true if the travel to the start of a copy rises in the layer `frame`. The bead before
/// this travel is not known, so it does not count as a top.
bool LiftsToStart(const RetractionOptions& retraction, const LayerFrame& frame);

}  // namespace slicefarm::motion
