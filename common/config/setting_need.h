#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/config/draft.h"
#include "common/model/options/settings.h"

namespace slicefarm::config {

/// Settings that do nothing unless others are so.
struct Need {
  std::string_view keys;  ///< by spaces
  std::string_view what;  ///< for people: "wipe = 1"
  bool (*met)(const JobRows&) = nullptr;
  bool (*met_by)(const Draft&) =
      nullptr;  ///< in its place, for flags that are no option of a stage
  /// Their standards follow others, so a profile that holds the numbers asks for nothing.
  bool only_requested = false;
};

/// The settings that were given and have no effect because another setting switches off what they
/// are about, as `key = value: needs ...`. A profile gives every setting there is, so of a profile
/// only those count that differ from their standard.
std::vector<std::string> UnmetNeeds(std::span<const Need> needs, const Draft& draft,
                                    const JobRows& settings);

}  // namespace slicefarm::config
