#pragma once

#include <span>
#include <string>
#include <string_view>

#include "common/model/process.h"

namespace slicefarm::config {

/// Returns the number of edits that turn `a` into `b`: insertions, deletions, replacements and
/// swaps of neighbouring characters. Cost: O(|a| |b|). Source: Damerau; optimal string alignment.
int EditDistance(std::string_view a, std::string_view b);

/// Returns the name in `names` that `word` most likely means, or an empty text if none is similar.
/// A missing or additional word, as in `bed_temp` or `layer_heights_mm`, counts as at most two
/// edits.
std::string Nearest(std::string_view word, std::span<const std::string_view> names);

/// Returns the setting of the process that `key` most likely means (settings_table.h), or an empty
/// text if none is similar.
std::string NearestSetting(std::string_view key, Process process);

}  // namespace slicefarm::config
