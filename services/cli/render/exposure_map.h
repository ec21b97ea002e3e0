#pragma once

#include <string_view>
#include <vector>

#include "services/cli/render/layer_drawing.h"

namespace slicefarm::cli {

/// How much each pixel of the part's picture gets from the runs of a layer, each with its width.
struct ExposureMap {
  std::string_view unit = "passes";
  std::vector<double> values;  ///< row by row from the top; empty if there is no room for it

  double Most() const;
};

/// In J/mm2 if the energy of all runs is known; else how often each pixel is passed over: 1 where
/// lines lie side by side, 2 where they overlap. Of runs of one energy up to kMostPasses are told
/// apart. Cost: O(pixels) for each energy, and O(moves).
inline constexpr double kMostPasses = 15;
ExposureMap MapExposure(const GcodeLayer& layer, const Layout& layout);

}  // namespace slicefarm::cli
