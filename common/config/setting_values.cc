#include "common/config/setting_values.h"

#include <cassert>

#include "common/config/table/settings_table.h"

namespace slicefarm::config {

SettingValues::SettingValues(Process process) : process_(process) {
  for (const SettingSpec& spec : SettingsTable(process)) {
    Entry entry{.written = std::string(spec.standard)};
    if (spec.standard != kNotSet) {
      auto value = ParseValue(spec, spec.standard);
      assert(value.ok());
      entry.value = *std::move(value);
    }
    entries_.push_back(std::move(entry));
  }
}

SettingValues::Entry& SettingValues::At(std::string_view key) {
  const int index = FindSetting(key, process_);
  assert(index >= 0);
  return entries_[index];
}

const SettingValues::Entry& SettingValues::At(std::string_view key) const {
  const int index = FindSetting(key, process_);
  assert(index >= 0);
  return entries_[index];
}

double SettingValues::Number(std::string_view key) const { return At(key).value->number; }

void SettingValues::SetNumber(std::string_view key, double number) {
  Value& value = *At(key).value;
  value.number = Quantise(number);
  value.percent = false;
}

}  // namespace slicefarm::config
