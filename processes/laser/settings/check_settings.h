#pragma once

#include "absl/status/status.h"
#include "common/config/setting_values.h"

namespace slicefarm::config::laser {

/// Checks rules between settings: widths of stripes and islands against overlaps and hatch
/// distances; gas_window for islands; powers against laser_full_power. Errors:
/// SETTING_OUT_OF_RANGE.
absl::Status CheckSettings(const SettingValues& draft);

}  // namespace slicefarm::config::laser
