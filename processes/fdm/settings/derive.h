#pragma once

#include "absl/status/status.h"
#include "common/config/draft.h"
#include "common/config/resolve.h"

namespace slicefarm::config::fdm {

/// Turns what refers to other settings into what it comes to, as PrusaSlicer does:
///   percentages of heights, widths and speeds; widths of 0 through `extrusion_width` to a multiple
///   of the nozzle's diameter; speeds of 0 to `max_print_speed`; accelerations of 0 to the next
///   more general one; outline_resolution to no less than resolution; shell thickness to a number
///   of layers; the filament's own retraction, G-code and volumetric limit.
/// Afterwards every number stands for itself (but for a `first_layer_speed` in percent, which is of
/// each feature's). What a profile asks for and is not made is told in `result`. Errors:
/// SETTING_OUT_OF_RANGE for what a percentage comes to.
absl::Status Derive(Draft& draft, ResolvedSettings& result);

}  // namespace slicefarm::config::fdm
