#pragma once

#include "absl/status/status.h"
#include "common/config/resolve.h"
#include "common/config/setting_values.h"

namespace slicefarm::config::fdm {

/// Replaces values that refer to other settings by numbers, as PrusaSlicer does:
/// - percentages of heights, widths and speeds: the absolute value;
/// - widths of 0: `extrusion_width`, or a multiple of the nozzle diameter;
/// - speeds of 0: `max_print_speed`;
/// - accelerations of 0: the next more general acceleration;
/// - outline_resolution: at least `resolution`;
/// - shell thickness: a number of layers;
/// - retraction, G-code and volumetric limit: the values of the filament, if it has its own.
///
/// Afterwards no value depends on another setting. The only exception is a `first_layer_speed` in
/// percent, which refers to the speed of each feature. `result` receives the requests of profiles
/// that are not fulfilled. Errors: SETTING_OUT_OF_RANGE for the result of a percentage.
absl::Status Derive(SettingValues& draft, ResolvedSettings& result);

}  // namespace slicefarm::config::fdm
