#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/config/setting_values.h"
#include "common/model/options/settings.h"

namespace slicefarm::config {

/// Settings that have no effect unless another setting has a certain value.
struct Need {
  std::string_view keys;  ///< names of the settings, separated by spaces
  std::string_view what;  ///< requirement for messages: "wipe = 1"
  bool (*met)(const JobRows&) = nullptr;
  bool (*met_by)(const SettingValues&) =
      nullptr;  ///< used instead of `met` for flags that are not options of a stage
  /// True if the defaults of the settings depend on other settings. Then a number in a profile does
  /// not count as a request.
  bool only_requested = false;
};

/// Returns the given settings that have no effect because another setting disables them, as `key =
/// value: needs ...`. A profile lists every setting, so settings of a profile count only if they
/// differ from their default.
std::vector<std::string> UnmetNeeds(std::span<const Need> needs, const SettingValues& draft,
                                    const JobRows& settings);

}  // namespace slicefarm::config
