#pragma once

#include <string_view>
#include <vector>

#include "common/model/setting.h"

namespace slicefarm::config {

/// Returns true if the author in a config.ini, or in the first line of a G-code file, is
/// SuperSlicer.
bool IsSuperSlicers(std::string_view text);

/// Converts settings of SuperSlicer to PrusaSlicer's, in their order.
///
/// Most settings have the same name in both programs, but some values differ in meaning.
/// SuperSlicer's widths are percentages of the nozzle diameter, PrusaSlicer's of the layer height.
/// SuperSlicer's speeds and accelerations are percentages of other base settings. Such percentages
/// become numbers; the base settings must be among `settings`. Choices that PrusaSlicer lacks
/// become the choices that SuperSlicer itself exports. Settings that only SuperSlicer has are kept,
/// because its G-code may use them. Cost: O(n log n) for n settings.
std::vector<Setting> FromSuperSlicer(std::vector<Setting> settings);

}  // namespace slicefarm::config
