#pragma once

#include <string_view>

namespace slicefarm {
struct JobRows;
}  // namespace slicefarm

namespace slicefarm::config {

class SettingValues;

/// Requirement of a setting: another setting must have a certain value, otherwise the setting has
/// no effect.
struct Need {
  std::string_view what;  ///< requirement for messages: "wipe = 1"
  bool (*met)(const JobRows&) = nullptr;
  /// Condition on settings that no row contains; used instead of `met`.
  bool (*met_by)(const SettingValues&) = nullptr;
  /// True if the default of the setting depends on other settings. Then a number in a profile does
  /// not count as a request.
  bool only_requested = false;
};

}  // namespace slicefarm::config
