#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/config/table/value.h"
#include "common/model/process.h"

namespace slicefarm::config {

/// Values of all settings during their conversion from text to JobRows, in the order of
/// SettingsTable(process()).
class SettingValues {
 public:
  /// Makes a draft with the default value of every setting of the process.
  explicit SettingValues(Process process);

  struct Entry {
    std::optional<Value> value = {};  ///< value; nullopt: the setting is `nil`
    std::string written = {};         ///< text that the user wrote, for errors
    std::string all = {};             ///< whole text of the list from which `value` was taken
    bool given = false;               ///< true if the value was given and is not just the default
    /// True if a person chose this setting. False for settings from a profile, which lists every
    /// setting.
    bool requested = false;
  };

  Process process() const { return process_; }
  std::vector<Entry>& entries() { return entries_; }
  const std::vector<Entry>& entries() const { return entries_; }

  /// Returns the entry of a setting. REQUIRES: `key` is in the table.
  Entry& At(std::string_view key);
  const Entry& At(std::string_view key) const;

  /// Returns the setting's value as a number. REQUIRES: the setting has a value (it is not `nil`).
  double Number(std::string_view key) const;
  void SetNumber(std::string_view key, double number);

 private:
  Process process_;
  std::vector<Entry> entries_;
};

}  // namespace slicefarm::config
