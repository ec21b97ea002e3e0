#pragma once

#include <span>

#include "processes/laser/model/exposed_layer.h"

namespace slicefarm {
struct ExposureOptions;
}  // namespace slicefarm

namespace slicefarm::exposure {

/// What the exposure of one layer takes. Jumps start at the layer's first line: the way to it and
/// the recoater's time belong to no layer. A line that starts where the last one ended needs no
/// jump. REQUIRES: all groups' settings are in `regions`.
ExposureReport ReportOf(const ExposedLayer& layer, std::span<const ExposureOptions> regions);

}  // namespace slicefarm::exposure
