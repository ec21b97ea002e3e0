#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/point.h"

namespace slicefarm {

/// Layers as high as the shape of the object allows.
struct AdaptiveHeights {
  bool on = false;           ///< adaptive_layer_height
  Coord cusp_nm = 100'000;   ///< adaptive_layer_cusp: the highest step, along the surface's normal
  Coord min_nm = 70'000;     ///< min_layer_height
  Coord max_nm = 300'000;    ///< max_layer_height; above 0
  double max_ratio = 1.5;    ///< adaptive_layer_ratio: of neighbours, 1 or more

  friend bool operator==(const AdaptiveHeights&, const AdaptiveHeights&) = default;
};

inline constexpr double kMostHeightRatio = 100;

/// How high a layer is at a height above the object's bottom.
struct LayerHeightAt {
  Coord z_nm = 0;
  Coord height_nm = 0;

  friend bool operator==(const LayerHeightAt&, const LayerHeightAt&) = default;
};

inline constexpr int kMaxLayerHeightPoints = 20'000;

/// "0;0.2;5;0.1": z and height by turns, mm; z does not fall. As PrusaSlicer, OrcaSlicer and Bambu
/// Studio write what was drawn by hand. Empty: none. Errors: InvalidArgument for anything else, for
/// heights outside 0.01 to 5 mm, and for more than kMaxLayerHeightPoints.
absl::StatusOr<std::vector<LayerHeightAt>> ParseLayerHeights(std::string_view text);

/// As ParseLayerHeights reads it; empty for none.
std::string PrintLayerHeights(const std::vector<LayerHeightAt>& heights);

}  // namespace slicefarm
