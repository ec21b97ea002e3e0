#pragma once

#include "common/config/draft.h"
#include "common/model/options/settings.h"

namespace slicefarm::config::fdm {

/// Under (over) a surface as many layers are solid as top_solid_layers (bottom_solid_layers) says,
/// and more until they are top_solid_min_thickness (bottom_solid_min_thickness) thick by their own
/// heights: the options name the most that it may take, and which of them can be spared.
void TakeShells(const Draft& draft, JobRows& settings);

/// How many layers on the bed are solid below a hollow object. REQUIRES: TakeShells.
int32_t BottomLayers(const JobRows& settings);

}  // namespace slicefarm::config::fdm
