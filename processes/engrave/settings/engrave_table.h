#pragma once

#include <vector>

#include "common/config/table/setting_spec.h"

namespace slicefarm::config::engrave {

/// Returns the settings of the texture, its lines, the machine and the file.
std::vector<SettingSpec> EngraveTable();

}  // namespace slicefarm::config::engrave
