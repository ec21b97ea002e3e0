#include "common/config/coverage.h"

#include <algorithm>
#include <map>

#include "common/base/text.h"
#include "common/config/table/known_keys.h"
#include "common/config/table/settings_table.h"

namespace slicefarm::config {
namespace {

/// Returns the substitute for a choice that is not supported. Returns an empty text if the choice
/// itself is supported.
std::string_view InsteadOf(const SettingSpec& spec, std::string_view value) {
  const std::string_view item = Trim(value.substr(0, value.find_first_of(",;")));
  const auto choice = std::ranges::find(spec.choices, item, &Choice::name);
  return choice == spec.choices.end() ? std::string_view() : choice->note;
}

void Add(const std::string& key, std::string_view value, Coverage& coverage) {
  if (const int index = FindSetting(key, Process::kFdm); index >= 0) {
    const std::string_view instead = InsteadOf(SettingsTable(Process::kFdm)[index], value);
    ++coverage.keys;
    ++(instead.empty() ? coverage.effect : coverage.partial);
    if (!instead.empty())
      coverage.without.push_back(key + " = " + std::string(value) + ": " + std::string(instead));
    return;
  }
  const KnownKey* const known = FindKnownKey(key);
  if (known != nullptr && !known->of_print && !known->reported) return;
  ++coverage.keys;
  if (known != nullptr && !known->of_print) {
    ++coverage.effect;
    return;
  }
  ++coverage.none;
  coverage.without.push_back(key + ": " + (known == nullptr ? "unknown" : std::string(known->why)));
}

}  // namespace

Coverage CoverageOf(std::span<const Setting> profile) {
  std::map<std::string, std::string> values;
  for (const Setting& setting : profile) values[setting.key] = setting.value;
  Coverage coverage;
  for (const auto& [key, value] : values) Add(key, value, coverage);
  return coverage;
}

}  // namespace slicefarm::config
