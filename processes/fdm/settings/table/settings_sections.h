#pragma once

#include <vector>

#include "common/config/table/setting_spec.h"

namespace slicefarm::config {

// The parts of the settings table, by what they are about.
std::vector<SettingSpec> LayerSettings();     ///< settings_layers.cc
std::vector<SettingSpec> WallSettings();      ///< settings_walls.cc
std::vector<SettingSpec> SeamSettings();      ///< settings_seams.cc
std::vector<SettingSpec> InfillSettings();    ///< settings_infill.cc
std::vector<SettingSpec> AdhesionSettings();  ///< settings_adhesion.cc
std::vector<SettingSpec> SpeedSettings();     ///< settings_speed.cc
std::vector<SettingSpec> FilamentSettings();  ///< settings_filament.cc
std::vector<SettingSpec> MachineSettings();   ///< settings_machine.cc
std::vector<SettingSpec> WritingSettings();   ///< settings_writing.cc
std::vector<SettingSpec> ExposureTable();     ///< settings_exposure.cc

}  // namespace slicefarm::config
