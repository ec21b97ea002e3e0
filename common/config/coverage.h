#pragma once

#include <span>
#include <string>
#include <vector>

#include "common/config/resolve.h"

namespace slicefarm::config {

/// Numbers of keys in a profile, by their effect. Values do not matter, with one exception: a key
/// with an unsupported choice counts as partial. Keys of print hosts and of resin printing are not
/// counted.
struct Coverage {
  int32_t keys = 0;
  int32_t effect = 0;   ///< keys that have their full effect, or that only describe the profile
  int32_t partial = 0;  ///< keys with an effect, but with a substitute for the given value
  int32_t none = 0;     ///< keys without an effect
  /// One line for each key that `partial` counts (`key = value: substitute`) or that `none` counts
  /// (`key: reason`), sorted by key.
  std::vector<std::string> without;
};

/// Returns the coverage of a profile of a filament printer. If a key is repeated, its last value
/// counts.
Coverage CoverageOf(std::span<const Setting> profile);

}  // namespace slicefarm::config
