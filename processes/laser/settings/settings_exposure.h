#pragma once

#include <vector>

#include "common/config/table/setting_spec.h"

namespace slicefarm::config::laser {

/// Returns the settings of scanning and of the file format.
std::vector<SettingSpec> ExposureTable();

}  // namespace slicefarm::config::laser
