#pragma once

#include <vector>

#include "common/config/table/setting_spec.h"

namespace slicefarm::config {

// The parts of the settings table that processes share: a process that slices meshes takes them
// into its own, with other standards and words where it needs them.
std::vector<SettingSpec> LayerSettings();  ///< how meshes become layers: settings_layers.cc
std::vector<SettingSpec> PlateSettings();  ///< where the machine has room: settings_plate.cc

}  // namespace slicefarm::config
