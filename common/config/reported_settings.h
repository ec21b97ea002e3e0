#pragma once

#include <map>
#include <string>
#include <string_view>

#include "common/config/setting_values.h"

namespace slicefarm::config {

/// Given settings that no stage uses, by key. Each value is on one line, in the form of a
/// config.ini. The G-code of profiles may query them (`{if printer_notes=~/.*MK3S.*/}`), and output
/// files quote them.
using ReportedSettings = std::map<std::string, std::string, std::less<>>;

/// Adds `key = value` to `told`. Keys that a template cannot name, and keys that known_keys.h
/// withholds, are not added. Control characters become spaces.
void Tell(std::string_view key, std::string_view value, ReportedSettings& told);

/// Adds the settings of `draft` that differ from their default and act only through other settings,
/// such as `extrusion_width`.
void TellDerived(const SettingValues& draft, ReportedSettings& told);

/// Returns the lines `key = value` of `text` with keys that occur in `code`, a G-code with
/// placeholders. The result may contain more lines than necessary, because each word in `code`
/// counts as a possible key.
std::string LinesNamedIn(std::string_view code, std::string_view text);

}  // namespace slicefarm::config
