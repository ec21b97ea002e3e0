#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace slicefarm::macro {

/// The `key = value` lines of a text, spaces around keys and values taken off; lines without "="
/// are left out. The views are into `text`.
std::vector<std::pair<std::string_view, std::string_view>> SettingLines(std::string_view text);

/// A value as it was before it was put on one line: "\n", "\r" and "\\" become what they stand for,
/// quotes around the whole go.
std::string UnescapeSetting(std::string_view value);

/// The texts of a setting, unescaped: of a list of texts (`PLA;PETG`, `"a; b";"c"`) each, else one.
std::vector<std::string> SettingItems(std::string_view key, std::string_view value);

}  // namespace slicefarm::macro
