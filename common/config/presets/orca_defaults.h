#pragma once

#include <string_view>

namespace slicefarm::config::presets {

/// Return the settings of OrcaSlicer's presets of one kind as lines `key = value` with the value
/// that the program takes if no preset has the setting. Lines without `=` are settings that have no
/// such value. Values have the escapes of a config.ini. Source: OrcaSlicer, February 2026.
std::string_view OrcaPrinterDefaults();
std::string_view OrcaProcessDefaults();
std::string_view OrcaFilamentDefaults();

}  // namespace slicefarm::config::presets
