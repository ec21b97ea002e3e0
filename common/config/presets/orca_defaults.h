#pragma once

#include <string_view>

namespace slicefarm::config::presets {

/// Returns OrcaSlicer's settings for printer presets, one setting per line. `key = value`: the
/// value that the program uses if no preset has the setting. `key` alone: the setting has no such
/// value. Values have the escapes of a config.ini. Source: OrcaSlicer, February 2026.
std::string_view OrcaPrinterDefaults();
/// Returns OrcaSlicer's settings for process presets, in the form of OrcaPrinterDefaults.
std::string_view OrcaProcessDefaults();
/// Returns OrcaSlicer's settings for filament presets, in the form of OrcaPrinterDefaults.
std::string_view OrcaFilamentDefaults();

}  // namespace slicefarm::config::presets
