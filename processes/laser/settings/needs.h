#pragma once

#include <vector>

#include "common/config/setting_need.h"

namespace slicefarm::config::laser {

/// What a file cannot say has an effect on the report alone: its times and energies.
std::vector<Need> Needs();

}  // namespace slicefarm::config::laser
