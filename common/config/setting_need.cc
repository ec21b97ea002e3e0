#include "common/config/setting_need.h"

#include <fmt/core.h>

#include "common/base/text.h"
#include "common/config/table/settings_table.h"

namespace slicefarm::config {
namespace {

/// Returns true if a person wants the setting. False if a profile merely lists it.
bool IsWanted(const Need& need, const SettingValues& draft, std::string_view key) {
  const SettingValues::Entry& entry = draft.At(key);
  if (!entry.given || !entry.value.has_value()) return false;
  if (need.only_requested) return entry.requested;
  const int index = FindSetting(key, draft.process());
  return entry.requested || !IsStandard(SettingsTable(draft.process())[index], entry.written);
}

bool IsMet(const Need& need, const SettingValues& draft, const JobRows& settings) {
  return need.met_by != nullptr ? need.met_by(draft) : need.met(settings);
}

}  // namespace

std::vector<std::string> UnmetNeeds(std::span<const Need> needs, const SettingValues& draft,
                                    const JobRows& settings) {
  std::vector<std::string> notes;
  for (const Need& need : needs) {
    if (IsMet(need, draft, settings)) continue;
    for (const std::string_view key : Split(need.keys, " ")) {
      if (IsWanted(need, draft, key))
        notes.push_back(fmt::format("{} = {}: needs {}", key, draft.At(key).written, need.what));
    }
  }
  return notes;
}

}  // namespace slicefarm::config
