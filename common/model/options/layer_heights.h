#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/point.h"

namespace slicefarm {

/// Options of adaptive layer heights, which follow the slope of the object's surface.
struct AdaptiveHeights {
  bool on = false;  ///< setting adaptive_layer_height
  /// `adaptive_layer_cusp`: largest step between layers, measured along the surface's normal
  Coord cusp_nm = 100'000;
  Coord min_nm = 70'000;   ///< setting min_layer_height
  Coord max_nm = 300'000;  ///< setting max_layer_height, above 0
  /// `adaptive_layer_ratio`: largest ratio of the heights of neighbouring layers, 1 or more
  double max_ratio = 1.5;

  friend bool operator==(const AdaptiveHeights&, const AdaptiveHeights&) = default;
};

inline constexpr double kMostHeightRatio = 100;

/// Layer height at a height above the object's bottom.
struct LayerHeightAt {
  Coord z_nm = 0;
  Coord height_nm = 0;

  friend bool operator==(const LayerHeightAt&, const LayerHeightAt&) = default;
};

inline constexpr int kMaxLayerHeightPoints = 20'000;

/// Parses a list of layer heights such as "0;0.2;5;0.1": alternately z and layer height, in mm. The
/// values of z must not decrease. PrusaSlicer, OrcaSlicer and Bambu Studio write hand-drawn layer
/// heights in this form. An empty text gives an empty list. Errors: InvalidArgument for any other
/// text, for layer heights outside 0.01 to 5 mm, and for more than kMaxLayerHeightPoints.
absl::StatusOr<std::vector<LayerHeightAt>> ParseLayerHeights(std::string_view text);

/// Returns the heights in the form that ParseLayerHeights reads. Returns an empty text for an empty
/// list.
std::string PrintLayerHeights(const std::vector<LayerHeightAt>& heights);

}  // namespace slicefarm
