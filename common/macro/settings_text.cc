#include "common/macro/settings_text.h"

#include <algorithm>

#include "common/base/text.h"

namespace slicefarm::macro {
namespace {

/// Returns true for lists of texts, which are written without quotes if no text needs them. Other
/// settings with one text may contain a ';'.
bool IsTextList(std::string_view key) {
  return key.starts_with("filament_") || key == "extruder_colour";
}

/// Returns the position of the ';' after the item that begins at `begin`, or the end. A ';' in
/// quotes is not a separator.
size_t ItemEnd(std::string_view list, size_t begin) {
  bool quoted = false;
  size_t at = begin;
  for (; at < list.size() && (quoted || list[at] != ';'); ++at) {
    if (quoted && list[at] == '\\') {
      ++at;
    } else if (list[at] == '"') {
      quoted = !quoted;
    }
  }
  return std::min(at, list.size());
}

}  // namespace

std::vector<std::pair<std::string_view, std::string_view>> SettingLines(std::string_view text) {
  std::vector<std::pair<std::string_view, std::string_view>> lines;
  while (!text.empty()) {
    const size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const size_t equals = line.find('=');
    if (equals == std::string_view::npos) continue;
    lines.emplace_back(Trim(line.substr(0, equals)), Trim(line.substr(equals + 1)));
  }
  return lines;
}

std::string UnescapeSetting(std::string_view value) {
  if (value.size() >= 2 && value.front() == '"' && value.back() == '"') {
    value = value.substr(1, value.size() - 2);
  }
  std::string text;
  text.reserve(value.size());
  for (size_t i = 0; i < value.size(); ++i) {
    if (value[i] != '\\' || i + 1 == value.size()) {
      text += value[i];
      continue;
    }
    const char c = value[++i];
    text += c == 'n' ? '\n' : c == 'r' ? '\r' : c;
  }
  return text;
}

std::vector<std::string> SettingItems(std::string_view key, std::string_view value) {
  const bool quoted = value.starts_with('"');
  if (!quoted && !IsTextList(key)) return {UnescapeSetting(value)};
  std::vector<std::string> items;
  for (size_t begin = 0; begin <= value.size();) {
    const size_t end = ItemEnd(value, begin);
    items.push_back(UnescapeSetting(Trim(value.substr(begin, end - begin))));
    begin = end + 1;
  }
  return items;
}

}  // namespace slicefarm::macro
