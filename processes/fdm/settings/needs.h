#pragma once

#include <vector>

#include "common/config/setting_need.h"

namespace slicefarm::config::fdm {

/// Of settings that have an effect on filament printing.
std::vector<Need> Needs();

}  // namespace slicefarm::config::fdm
