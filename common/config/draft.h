#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/config/table/value.h"
#include "common/model/process.h"

namespace slicefarm::config {

/// The values of all settings on their way from text to JobRows, in the order of
/// SettingsTable(process()).
class Draft {
 public:
  /// Every setting of the process at its standard.
  explicit Draft(Process process);

  struct Entry {
    std::optional<Value> value = {};  ///< none: `nil`
    std::string written = {};         ///< as the user wrote it, for errors
    std::string all = {};             ///< the list that it comes from
    bool given = false;               ///< not the standard
    bool requested = false;           ///< by a person, who names no more than they want
  };

  Process process() const { return process_; }
  std::vector<Entry>& entries() { return entries_; }
  const std::vector<Entry>& entries() const { return entries_; }

  /// REQUIRES: `key` stands in the table.
  Entry& At(std::string_view key);
  const Entry& At(std::string_view key) const;

  /// REQUIRES: the setting has a value.
  double Number(std::string_view key) const;
  void SetNumber(std::string_view key, double number);

 private:
  Process process_;
  std::vector<Entry> entries_;
};

}  // namespace slicefarm::config
