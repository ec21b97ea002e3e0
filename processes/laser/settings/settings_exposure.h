#pragma once

#include <vector>

#include "common/config/table/setting_spec.h"

namespace slicefarm::config::laser {

/// How layers are scanned, and what the file says of it.
std::vector<SettingSpec> ExposureTable();

}  // namespace slicefarm::config::laser
