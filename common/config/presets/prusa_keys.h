#pragma once

#include <string_view>

#include "common/config/presets/preset.h"

namespace slicefarm::config::presets {

/// Returns the keys of PrusaSlicer's presets of one kind, each followed by a space. Source:
/// PrusaSlicer 2.9.4.
std::string_view PrusaKeys(PresetKind kind);

}  // namespace slicefarm::config::presets
