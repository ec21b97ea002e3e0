#pragma once

#include <optional>
#include <string_view>

namespace slicefarm::macro {

/// What a setting of PrusaSlicer's (2.5 to 2.9) is to a template. It decides more than it seems:
/// `1` may be a whole number, a real one or a truth value, and 1 / 2 comes to 0 or 0.5.
struct SettingType {
  enum class Of { kFlag, kWhole, kNumber, kPercent, kNumberOrPercent, kChoice, kPoint, kText };
  Of of = Of::kText;
  bool is_list = false;  ///< one for each extruder, or mode of the machine

  friend bool operator==(const SettingType&, const SettingType&) = default;
};

/// None: PrusaSlicer has no such setting. Source: its PrintConfig.
std::optional<SettingType> TypeOfSetting(std::string_view key);

}  // namespace slicefarm::macro
