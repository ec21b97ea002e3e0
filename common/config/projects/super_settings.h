#pragma once

#include <string_view>
#include <vector>

#include "common/model/setting.h"

namespace slicefarm::config {

/// Returns true if a config.ini, or the first line of a G-code file, names SuperSlicer as its
/// author.
bool IsSuperSlicers(std::string_view text);

/// Converts settings of SuperSlicer to PrusaSlicer's, in their order.
///
/// Most names are equal in both programs, but some values differ in meaning. SuperSlicer's widths
/// are percentages of the nozzle, PrusaSlicer's of the layer. Its speeds and accelerations are
/// percentages of other base settings. Such percentages become numbers; the base settings must be
/// among `settings`. Choices that PrusaSlicer lacks become the choices that SuperSlicer itself
/// exports. Names that only SuperSlicer has stay, because its G-code may use them. Cost: O(n log
/// n).
std::vector<Setting> FromSuperSlicer(std::vector<Setting> settings);

}  // namespace slicefarm::config
