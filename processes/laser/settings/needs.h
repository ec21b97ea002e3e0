#pragma once

#include <vector>

#include "common/config/setting_need.h"

namespace slicefarm::config::laser {

/// Returns the conditions under which settings have an effect. A setting that the file format
/// cannot express still affects the times and energies in the report.
std::vector<Need> Needs();

}  // namespace slicefarm::config::laser
