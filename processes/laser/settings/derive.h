#pragma once

#include "absl/status/status.h"
#include "common/config/setting_values.h"

namespace slicefarm::config::laser {

/// Replaces values that refer to other settings by numbers: first_layer_height in percent, and
/// outline_resolution, which is at least resolution. Errors: SETTING_OUT_OF_RANGE for the result of
/// a percentage.
absl::Status Derive(SettingValues& draft);

}  // namespace slicefarm::config::laser
