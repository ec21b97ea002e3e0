#pragma once

#include "absl/status/status.h"
#include "common/config/setting_values.h"

namespace slicefarm::config::fdm {

/// Checks derived settings (derive.h) against each other. Layers must be no higher than the nozzle
/// diameter. Beads must be at least as wide as their layer is high, and narrower than three nozzle
/// diameters (PrusaSlicer's rules). Retractions need a speed, and gap widths must be in ascending
/// order. Errors: SETTING_OUT_OF_RANGE naming both settings, with metadata `setting`, `value`,
/// `min`, `max`.
absl::Status CheckSettings(const SettingValues& draft);

}  // namespace slicefarm::config::fdm
