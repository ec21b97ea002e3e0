#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "common/config/setting_values.h"
#include "common/config/table/settings_table.h"

namespace slicefarm::config::fdm {

using Pairs = std::vector<std::pair<std::string, std::string>>;

/// Returns the default settings with these changes, as Resolve reads them.
inline SettingValues DraftOf(const Pairs& given) {
  SettingValues draft(Process::kFdm);
  for (const auto& [key, text] : given) {
    SettingValues::Entry& entry = draft.At(key);
    if (text == kNotSet) {
      entry.value.reset();
    } else if (auto value =
                   ParseValue(SettingsTable(Process::kFdm)[FindSetting(key, Process::kFdm)], text);
               value.ok()) {
      entry.value = *std::move(value);
    } else {
      ADD_FAILURE() << value.status();
    }
    entry.written = text;
    entry.given = entry.requested = true;
  }
  return draft;
}

}  // namespace slicefarm::config::fdm
