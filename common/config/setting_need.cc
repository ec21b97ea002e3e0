#include "common/config/setting_need.h"

#include <fmt/core.h>

#include "common/config/table/need.h"
#include "common/config/table/settings_table.h"

namespace slicefarm::config {
namespace {

/// Returns true if a person wants the setting. False if a profile merely lists it.
bool IsWanted(const Need& need, const SettingSpec& spec, const SettingValues::Entry& entry) {
  return entry.requested || (!need.only_requested && !IsStandard(spec, entry.written));
}

bool IsMet(const Need& need, const SettingValues& draft, const JobRows& settings) {
  return need.met_by != nullptr ? need.met_by(draft) : need.met(settings);
}

}  // namespace

std::vector<SettingNote> UnmetNeeds(const SettingValues& draft, const JobRows& settings) {
  std::vector<SettingNote> notes;
  const auto table = SettingsTable(draft.process());
  for (size_t i = 0; i < table.size(); ++i) {
    const SettingValues::Entry& entry = draft.entries()[i];
    if (!entry.given || !entry.value.has_value()) continue;
    for (const Need* need : table[i].needs) {
      if (IsWanted(*need, table[i], entry) && !IsMet(*need, draft, settings))
        notes.push_back(
            {.text = fmt::format("{} = {}: needs {}", table[i].key, entry.written, need->what),
             .key = std::string(table[i].key),
             .why = SettingNote::Why::kUnmetNeed});
    }
  }
  return notes;
}

}  // namespace slicefarm::config
