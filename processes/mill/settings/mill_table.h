#pragma once

#include <vector>

#include "common/config/table/setting_spec.h"

namespace slicefarm::config::mill {

/// Returns the settings of the cutter, the strategy, the machine and the file.
std::vector<SettingSpec> MillTable();

}  // namespace slicefarm::config::mill
