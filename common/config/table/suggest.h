#pragma once

#include <span>
#include <string>
#include <string_view>

#include "common/model/process.h"

namespace slicefarm::config {

/// How many insertions, deletions, replacements and swaps of neighbours make `a` into `b`. Cost:
/// O(|a| |b|). Source: Damerau; optimal string alignment.
int EditDistance(std::string_view a, std::string_view b);

/// Returns the one of `names` that `word` most likely means, or "": none comes near. A word left
/// out or added, as in `bed_temp` or `layer_heights_mm`, counts as two edits at most.
std::string Nearest(std::string_view word, std::span<const std::string_view> names);

/// The setting of the process that `key` most likely means (settings_table.h), or "": none comes
/// near.
std::string NearestSetting(std::string_view key, Process process);

}  // namespace slicefarm::config
