#include "common/config/setting_need.h"

#include <fmt/core.h>

#include <algorithm>

#include "common/base/text.h"
#include "common/config/table/need.h"
#include "common/config/table/settings_table.h"

namespace slicefarm::config {
namespace {

/// Returns true if the profile also gives a setting that the need names. A whole profile has
/// switched the feature off then, and merely lists the values for it.
bool GivesSwitch(const Need& need, const SettingValues& draft) {
  const std::vector<std::string_view> words = Split(need.what, " ,");
  return std::ranges::any_of(words, [&](std::string_view word) {
    const int index = FindSetting(word, draft.process());
    return index >= 0 && draft.entries()[static_cast<size_t>(index)].given;
  });
}

/// Returns true if a person wants the setting. False if a profile merely lists it.
bool IsWanted(const Need& need, const SettingSpec& spec, const SettingValues::Entry& entry,
              const SettingValues& draft) {
  if (entry.requested) return true;
  return !need.only_requested && !IsStandard(spec, entry.written) && !GivesSwitch(need, draft);
}

bool IsMet(const Need& need, const SettingValues& draft, const JobRows& settings) {
  return need.met_by != nullptr ? need.met_by(draft) : need.met(settings);
}

}  // namespace

const Need* UnmetNeedOf(const SettingSpec& spec, const SettingValues& draft,
                        const JobRows& settings) {
  const auto unmet = std::ranges::find_if(
      spec.needs, [&](const Need* need) { return !IsMet(*need, draft, settings); });
  return unmet == spec.needs.end() ? nullptr : *unmet;
}

std::vector<SettingNote> UnmetNeeds(const SettingValues& draft, const JobRows& settings) {
  std::vector<SettingNote> notes;
  const auto table = SettingsTable(draft.process());
  for (size_t i = 0; i < table.size(); ++i) {
    const SettingValues::Entry& entry = draft.entries()[i];
    if (!entry.given || !entry.value.has_value()) continue;
    for (const Need* need : table[i].needs) {
      if (IsWanted(*need, table[i], entry, draft) && !IsMet(*need, draft, settings))
        notes.push_back(
            {.text = fmt::format("{} = {}: needs {}", table[i].key, entry.written, need->what),
             .key = std::string(table[i].key),
             .why = SettingNote::Why::kUnmetNeed});
    }
  }
  return notes;
}

}  // namespace slicefarm::config
