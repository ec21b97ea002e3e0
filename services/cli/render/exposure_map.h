#pragma once

#include <string_view>
#include <vector>

#include "services/cli/render/layer_drawing.h"

namespace slicefarm::cli {

/// Exposure of each pixel of the part's picture by the runs of a layer, each with its width.
struct ExposureMap {
  std::string_view unit = "passes";
  /// Values row by row from the top; empty if there is not enough memory.
  std::vector<double> values;

  /// Returns the largest value.
  double Most() const;
};

/// Largest number of passes of one energy that are distinguished.
inline constexpr double kMostPasses = 15;
/// Returns the exposure in J/mm2 if the energy of all runs is known. Otherwise it returns the
/// number of passes over each pixel: 1 where lines are side by side, 2 where they overlap. Runs of
/// one energy are counted up to kMostPasses. Cost: O(pixels) for each energy, and O(moves).
ExposureMap MapExposure(const GcodeLayer& layer, const Layout& layout);

}  // namespace slicefarm::cli
