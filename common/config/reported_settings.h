#pragma once

#include <map>
#include <string>
#include <string_view>

#include "common/config/setting_values.h"

namespace slicefarm::config {

/// Given settings that no stage uses: key and value. Each value is on one line, in the form of a
/// config.ini. The G-code of profiles may query these settings (`{if printer_notes=~/.*MK3S.*/}`),
/// and output files quote them.
using ReportedSettings = std::map<std::string, std::string, std::less<>>;

/// Adds `key = value` to `reported`. Two kinds of keys are not added: keys that a template cannot
/// name, and private keys (KnownKey::reported is false). Control characters in the value become
/// spaces.
void Report(std::string_view key, std::string_view value, ReportedSettings& reported);

/// Adds the given settings of `draft` that differ from their default and act only through other
/// settings, such as `extrusion_width`. Settings with G-code are left out.
void ReportDerived(const SettingValues& draft, ReportedSettings& reported);

/// Returns the lines `key = value` of `text` for the keys that occur in `code`, a G-code with
/// placeholders. The result may contain more lines than necessary, because each word in `code`
/// counts as a possible key.
std::string LinesNamedIn(std::string_view code, std::string_view text);

}  // namespace slicefarm::config
