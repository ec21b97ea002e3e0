#pragma once

#include <string_view>
#include <vector>

#include "services/cli/render/layer_drawing.h"

namespace slicefarm::cli {

/// Exposure of each pixel of the part's picture, computed from the BeadRuns of a layer
/// (gcode_reader.h) and their widths.
struct ExposureMap {
  std::string_view unit = "passes";
  /// Exposure of each pixel, row by row from the top; empty if there is not enough memory.
  std::vector<double> values;

  /// Returns the largest element of `values`.
  double Most() const;
};

/// Largest number of passes that is counted on a pixel for runs of the same energy.
inline constexpr double kMostPasses = 15;
/// Returns the exposure in J/mm2 if the energy of all runs is known. Otherwise returns the number
/// of passes over each pixel: 1 where lines are side by side, 2 where they overlap. Counts at most
/// kMostPasses passes of runs with the same energy. Cost: O(pixels * different energies + moves).
ExposureMap MapExposure(const GcodeLayer& layer, const Layout& layout);

}  // namespace slicefarm::cli
