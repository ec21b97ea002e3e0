#pragma once

#include <optional>
#include <string_view>

namespace slicefarm::macro {

/// Type of a setting of PrusaSlicer (2.5 to 2.9) in templates. The type matters: `1` may be an
/// integer, a real number or a boolean, and 1 / 2 gives 0 or 0.5.
struct SettingType {
  enum class Of { kFlag, kWhole, kNumber, kPercent, kNumberOrPercent, kChoice, kPoint, kText };
  Of of = Of::kText;
  /// true if the setting has one value for each extruder, or for each mode of the machine
  bool is_list = false;

  friend bool operator==(const SettingType&, const SettingType&) = default;
};

/// Returns the type of a setting; nullopt if PrusaSlicer has no such setting. Source: PrusaSlicer's
/// PrintConfig.
std::optional<SettingType> TypeOfSetting(std::string_view key);

}  // namespace slicefarm::macro
