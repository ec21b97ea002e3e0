#pragma once

#include <vector>

#include "common/config/table/setting_spec.h"

namespace slicefarm::config::fdm {

/// Says of each setting where it may be given, as PrusaSlicer has it. Those that all processes
/// share say it themselves.
void SetScopes(std::vector<SettingSpec>& table);

}  // namespace slicefarm::config::fdm
