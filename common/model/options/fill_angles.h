#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace slicefarm {

/// How infill turns in one layer.
struct AngleStep {
  bool relative = false;  ///< to the layer below; else to the object
  double degrees = 0;

  friend bool operator==(const AngleStep&, const AngleStep&) = default;
};

/// A template of angles by layer: items by commas, which start over after the last. `45` is an
/// angle, `+30` and `-30` turn on from the layer below, `#N` behind an item repeats it in N layers:
///     0,90        +30        0#2,45#2,90#2
/// A turn in the lowest layer is one from `fill_angle`.
/// Errors: InvalidArgument for no item, anything else than numbers up to 360 degrees, or more than
/// kMaxAngleSteps layers.
absl::StatusOr<std::vector<AngleStep>> ParseFillAngles(std::string_view text);
inline constexpr int kMaxAngleSteps = 1000;

/// As ParseFillAngles reads it; equal items in a row are one.
std::string PrintFillAngles(const std::vector<AngleStep>& steps);

/// In degrees, [0, 360), of an object's own layer. REQUIRES: steps are not empty, layer >= 0.
/// Cost: O(steps).
double FillAngleAt(const std::vector<AngleStep>& steps, double base_degrees, int32_t layer);

}  // namespace slicefarm
