#include "common/config/reported_settings.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "absl/strings/ascii.h"
#include "common/base/text.h"
#include "common/config/table/known_keys.h"
#include "common/config/table/settings_table.h"

namespace slicefarm::config {
namespace {

bool IsName(std::string_view key) {
  return !key.empty() && !absl::ascii_isdigit(key[0]) &&
         std::all_of(key.begin(), key.end(), IsOfName);
}

/// Template variable that represents a setting of another name.
struct Alias {
  std::string_view variable;
  std::string_view key;
};
constexpr Alias kAliases[] = {
    {"print_bed_min", "bed_shape"},
    {"print_bed_max", "bed_shape"},
    {"print_bed_size", "bed_shape"},
    {"print_preset", "print_settings_id"},
    {"printer_preset", "printer_settings_id"},
    {"filament_preset", "filament_settings_id"},
    {"initial_filament_type", "filament_type"},
    {"printing_filament_types", "filament_type"},
    {"initial_tool", "extruder"},
    {"initial_extruder", "extruder"},
    {"current_extruder", "extruder"},
    {"filament_extruder_id", "extruder"},
    {"is_extruder_used", "extruder"},
    {"extruder_count", "num_extruders"},
    {"timestamp", "creation_time"},
    {"year", "creation_time"},
    {"month", "creation_time"},
    {"day", "creation_time"},
    {"hour", "creation_time"},
    {"minute", "creation_time"},
    {"second", "creation_time"},
    {"physical_printer_preset", "physical_printer_settings_id"},
};

/// Removes the index: `temperature_0` is the first item of `temperature`.
std::string_view WithoutIndex(std::string_view word) {
  size_t end = word.size();
  while (end > 0 && absl::ascii_isdigit(word[end - 1])) --end;
  const bool indexed = end < word.size() && end > 1 && word[end - 1] == '_';
  return indexed ? word.substr(0, end - 1) : word;
}

std::set<std::string_view> WordsOf(std::string_view code) {
  std::set<std::string_view> words;
  while (!code.empty()) {
    const auto begin = std::find_if(code.begin(), code.end(), IsOfName);
    const auto end = std::find_if_not(begin, code.end(), IsOfName);
    const std::string_view word(begin, end);
    code = std::string_view(end, code.end());
    words.insert(word);
    words.insert(WithoutIndex(word));
    for (const Alias& alias : kAliases) {
      if (alias.variable == WithoutIndex(word)) words.insert(alias.key);
    }
  }
  return words;
}

}  // namespace

void Report(std::string_view key, std::string_view value, ReportedSettings& reported) {
  const KnownKey* known = FindKnownKey(key);
  if (!IsName(key) || (known != nullptr && !known->reported)) return;
  std::string line(value);
  std::replace_if(line.begin(), line.end(), IsControl, ' ');
  reported[std::string(key)] = std::string(Trim(line));
}

void ReportDerived(const SettingValues& draft, ReportedSettings& reported) {
  const auto table = SettingsTable(draft.process());
  for (size_t i = 0; i < table.size(); ++i) {
    const SettingValues::Entry& entry = draft.entries()[i];
    if (table[i].field.get != nullptr || !entry.given || !entry.value.has_value()) continue;
    // Default values that a profile lists are left out, so that equal jobs give equal bytes.
    if (IsStandard(table[i], entry.written)) continue;
    // G-code is left out: the filament's end G-code is already part of end_gcode, and must not
    // occur twice.
    if (table[i].kind != Kind::kGcode) Report(table[i].key, entry.written, reported);
  }
}

std::string LinesNamedIn(std::string_view code, std::string_view text) {
  const std::set<std::string_view> words = WordsOf(code);
  std::string named;
  for (const std::string_view line : Split(text, "\n")) {
    const std::string_view key = Trim(line.substr(0, line.find('=')));
    if (!key.empty() && words.contains(key)) named += fmt::format("{}\n", line);
  }
  return named;
}

}  // namespace slicefarm::config
