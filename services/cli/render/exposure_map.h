#pragma once

#include <string_view>
#include <vector>

#include "services/cli/render/layer_drawing.h"

namespace slicefarm::cli {

/// Exposure of each pixel of the part's picture. It is computed from the runs of a layer and their
/// widths.
struct ExposureMap {
  std::string_view unit = "passes";
  /// Exposure of each pixel, row by row from the top; empty if there is not enough memory.
  std::vector<double> values;

  /// Returns the largest value.
  double Most() const;
};

/// Number up to which the passes of runs with the same energy are counted on a pixel.
inline constexpr double kMostPasses = 15;
/// Returns the exposure in J/mm2 if the energy of all runs is known. Otherwise it returns the
/// number of passes over each pixel: 1 where lines are side by side, 2 where they overlap. On each
/// pixel, runs of the same energy are counted up to kMostPasses. Cost: O(pixels * different
/// energies + moves).
ExposureMap MapExposure(const GcodeLayer& layer, const Layout& layout);

}  // namespace slicefarm::cli
