#pragma once

#include <span>
#include <string>
#include <vector>

#include "common/config/resolve.h"

namespace slicefarm::config {

/// How much of a profile counts, key by key and whatever the values are. Keys that concern print
/// hosts or resin are not among them.
struct Coverage {
  int32_t keys = 0;
  int32_t effect = 0;   ///< has its effect, or describes the profile and is told as such
  int32_t partial = 0;  ///< has an effect, but something else is done for the value that is given
  int32_t none = 0;
  std::vector<std::string> without;  ///< `key: why`, of partial and none, sorted
};

Coverage CoverageOf(std::span<const Setting> profile);

}  // namespace slicefarm::config
