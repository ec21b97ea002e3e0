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
  /// requirement for messages, such as "wipe = 1"; it names the settings that can disable the
  /// setting (setting_need.cc)
  std::string_view what;
  bool (*met)(const JobRows&) = nullptr;
  /// Condition on settings that no row contains; used instead of `met`.
  bool (*met_by)(const SettingValues&) = nullptr;
  /// True if a value in a profile is no request, for example because the default of the setting
  /// depends on other settings.
  bool only_requested = false;
};

}  // namespace slicefarm::config
