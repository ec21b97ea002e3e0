#pragma once

#include <vector>

#include "common/config/table/setting_spec.h"

namespace slicefarm::config::engrave {

/// The texture, its lines, the machine, and the file.
std::vector<SettingSpec> EngraveTable();

}  // namespace slicefarm::config::engrave
