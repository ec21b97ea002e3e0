#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace slicefarm::macro {

/// Returns the `key = value` lines of a text, without spaces around keys and values. Lines without
/// "=" are left out. The views refer to `text`.
std::vector<std::pair<std::string_view, std::string_view>> SettingLines(std::string_view text);

/// Returns the original of a value that was written on one line: replaces "\n", "\r" and "\\", and
/// removes quotes around the whole value.
std::string UnescapeSetting(std::string_view value);

/// Returns the unescaped texts of a setting: all items if the setting is a list of texts
/// (`PLA;PETG`, `"a; b";"c"`), otherwise one text.
std::vector<std::string> SettingItems(std::string_view key, std::string_view value);

}  // namespace slicefarm::macro
