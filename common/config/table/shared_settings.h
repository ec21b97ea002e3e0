#pragma once

#include <vector>

#include "common/config/table/setting_spec.h"

namespace slicefarm::config {

// Parts of the settings table that processes share. A process that slices meshes includes them in
// its own table, if necessary with other defaults and descriptions.
std::vector<SettingSpec> LayerSettings();  ///< layers of meshes: settings_layers.cc
std::vector<SettingSpec> PlateSettings();  ///< build volume and plate: settings_plate.cc

}  // namespace slicefarm::config
