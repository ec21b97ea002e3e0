#pragma once

#include "absl/status/status.h"
#include "common/config/setting_values.h"

namespace slicefarm::config::laser {

/// Checks that the values are consistent with each other. Errors: SETTING_OUT_OF_RANGE.
absl::Status CheckSettings(const SettingValues& draft);

}  // namespace slicefarm::config::laser
