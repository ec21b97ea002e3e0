#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "common/config/presets/preset.h"

namespace slicefarm::config::presets {

/// Returns true if presets of this kind may have the setting. The programs ignore settings in a
/// preset of another kind. Settings that are in no list of the program belong to any kind.
bool MayHaveKey(PresetKind kind, PresetDialect dialect, std::string_view key);

/// Returns keys and values that OrcaSlicer takes if no preset of this kind has the setting.
const std::vector<std::pair<std::string_view, std::string_view>>& OrcaDefaultsOf(PresetKind kind);

}  // namespace slicefarm::config::presets
