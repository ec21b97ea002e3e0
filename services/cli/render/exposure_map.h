#pragma once

#include <cstdint>
#include <vector>

#include "services/cli/render/layer_drawing.h"

namespace slicefarm::cli {

/// How often each pixel of the part's picture is passed over by the runs of a layer, each with its
/// width: 1 where lines lie side by side, 2 where they overlap. With one speed and power that is
/// the energy, in units of one pass. Row by row from the top. Up to kMostPasses are told apart.
/// Empty if there is no room for it. Cost: O(pixels + moves).
inline constexpr double kMostPasses = 15;
std::vector<double> ExposureMap(const GcodeLayer& layer, const Layout& layout);

}  // namespace slicefarm::cli
