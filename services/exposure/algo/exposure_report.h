#pragma once

#include <span>

#include "processes/laser/model/exposed_layer.h"

namespace slicefarm {
struct ExposureOptions;
}  // namespace slicefarm

namespace slicefarm::exposure {

/// Returns lengths, times and energy of the exposure of one layer. The report begins with the
/// layer's first line: the jump to this line and the recoater's time are counted in no layer. A
/// line that starts at the end of the previous line needs no jump. REQUIRES: the settings of all
/// groups are in `regions`.
ExposureReport ReportOf(const ExposedLayer& layer, std::span<const ExposureOptions> regions);

}  // namespace slicefarm::exposure
