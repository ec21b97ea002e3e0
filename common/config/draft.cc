#include "common/config/draft.h"

#include <cassert>

#include "common/config/table/settings_table.h"

namespace slicefarm::config {

Draft::Draft(Process process) : process_(process) {
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

Draft::Entry& Draft::At(std::string_view key) {
  const int index = FindSetting(key, process_);
  assert(index >= 0);
  return entries_[index];
}

const Draft::Entry& Draft::At(std::string_view key) const {
  const int index = FindSetting(key, process_);
  assert(index >= 0);
  return entries_[index];
}

double Draft::Number(std::string_view key) const { return At(key).value->number; }

void Draft::SetNumber(std::string_view key, double number) {
  Value& value = *At(key).value;
  value.number = Quantise(number);
  value.percent = false;
}

}  // namespace slicefarm::config
