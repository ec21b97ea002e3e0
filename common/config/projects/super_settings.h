#pragma once

#include <string_view>
#include <vector>

#include "common/model/setting.h"

namespace slicefarm::config {

/// Whether a config.ini, or the first line of a G-code file, says that SuperSlicer made it.
bool IsSuperSlicers(std::string_view text);

/// Settings of SuperSlicer's as PrusaSlicer would have them, in their order.
///
/// Both have most names, but not what some values mean: SuperSlicer's widths are percentages of the
/// nozzle, PrusaSlicer's of the layer; its speeds and accelerations are percentages of each other
/// in another way. Those become numbers, for which the settings they relate to must be among
/// `settings`. Choices that PrusaSlicer has not become those that SuperSlicer itself exports for
/// it. Names of SuperSlicer's alone stay, as its G-code may name them. Cost: O(n log n).
std::vector<Setting> FromSuperSlicer(std::vector<Setting> settings);

}  // namespace slicefarm::config
