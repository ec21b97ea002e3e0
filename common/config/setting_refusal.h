#pragma once

#include <limits>
#include <string_view>

#include "absl/status/status.h"
#include "common/config/setting_values.h"

namespace slicefarm::config {

inline constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// Returns SETTING_OUT_OF_RANGE for setting `key`, a length in mm that is inconsistent with other
/// settings. `rule`: text "it must ..." for the message. `min`, `max`: bounds in mm; a `min` of 0
/// or a `max` of kUnbounded means no bound.
absl::Status Refuse(const SettingValues& draft, std::string_view key, std::string_view rule,
                    double min, double max);

}  // namespace slicefarm::config
