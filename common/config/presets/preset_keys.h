#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "common/config/presets/preset.h"

namespace slicefarm::config::presets {

/// Returns true if presets of this kind may have the setting. The programs ignore a setting in a
/// preset of another kind. Also returns true for a setting that the program's lists of all kinds
/// lack.
bool MayHaveKey(PresetKind kind, PresetDialect dialect, std::string_view key);

/// Returns the keys and values that OrcaSlicer uses for settings that no preset of this kind has.
const std::vector<std::pair<std::string_view, std::string_view>>& OrcaDefaultsOf(PresetKind kind);

}  // namespace slicefarm::config::presets
