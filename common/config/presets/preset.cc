#include "common/config/presets/preset.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "common/base/text.h"

namespace slicefarm::config::presets {
namespace {

/// Takes a text in quotes off the front of `text`, with its escapes resolved.
std::string TakeQuoted(std::string_view& text) {
  std::string item;
  size_t at = 1;
  for (; at < text.size() && text[at] != '"'; ++at) {
    const bool escaped = text[at] == '\\' && at + 1 < text.size();
    if (escaped) ++at;
    item += escaped && text[at] == 'n' ? '\n' : text[at];
  }
  text.remove_prefix(std::min(at + 1, text.size()));
  return item;
}

/// Takes one item of `a;"b; c"` off the front of `text`, and the separator after it.
std::string TakeListItem(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  std::string item;
  if (text.starts_with('"')) item = TakeQuoted(text);
  const size_t end = std::min(text.find(';'), text.size());
  item += Trim(text.substr(0, end));
  text.remove_prefix(std::min(end + 1, text.size()));
  return item;
}

}  // namespace

std::string_view KindName(PresetKind kind) {
  switch (kind) {
    case PresetKind::kPrinter:
      return "printer";
    case PresetKind::kProcess:
      return "process";
    case PresetKind::kFilament:
      return "filament";
  }
  return "";
}

std::vector<std::string> ListItems(std::string_view text) {
  std::vector<std::string> items;
  const auto add = [&](std::string item) {
    if (!item.empty()) items.push_back(std::move(item));
  };
  if (text.starts_with('[')) {
    const auto list = nlohmann::json::parse(text.begin(), text.end(), nullptr, false);
    if (list.is_array())
      for (const auto& item : list)
        if (item.is_string()) add(item.get<std::string>());
    return items;
  }
  while (!text.empty()) add(TakeListItem(text));
  return items;
}

double FirstNumber(std::string_view list) {
  const std::vector<std::string> items = ListItems(list);
  return items.empty() ? 0 : ToNumber(Trim(Split(items.front(), ",").front())).value_or(0);
}

std::string AliasOf(std::string_view name) {
  return std::string(Trim(name.substr(0, name.find('@'))));
}

}  // namespace slicefarm::config::presets
