#include "common/config/derive_steps.h"

#include <algorithm>

#include "common/config/table/settings_table.h"

namespace slicefarm::config {

double Absolute(const Value& value, double whole) {
  return value.percent ? value.number / 100 * whole : value.number;
}

void ResolvePercentage(SettingValues& draft, std::string_view key) {
  const std::string_view whole =
      SettingsTable(draft.process())[FindSetting(key, draft.process())].relative_to;
  draft.SetNumber(key, Absolute(*draft.At(key).value, draft.Number(whole)));
}

void FallBack(SettingValues& draft, std::string_view key, std::string_view to) {
  if (draft.Number(key) == 0) draft.SetNumber(key, draft.Number(to));
}

void RaiseTo(SettingValues& draft, std::string_view key, std::string_view least) {
  draft.SetNumber(key, std::max(draft.Number(key), draft.Number(least)));
}

absl::Status CheckPercentages(const SettingValues& draft) {
  const auto table = SettingsTable(draft.process());
  for (const bool given : {true, false}) {  // what the user wrote is to blame before what follows
    for (size_t i = 0; i < table.size(); ++i) {
      const SettingValues::Entry& entry = draft.entries()[i];
      if (table[i].kind != Kind::kNumberOrPercent || entry.given != given) continue;
      if (table[i].standard == kNotSet) continue;  // counts where it takes another one's place
      const absl::Status status = CheckRange(table[i], entry.value->number, entry.written);
      if (!status.ok()) return status;
    }
  }
  return absl::OkStatus();
}

}  // namespace slicefarm::config
