#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace slicefarm {

/// Infill angle of one layer.
struct AngleStep {
  /// true: the angle is relative to the layer below; false: relative to the object
  bool relative = false;
  double degrees = 0;

  friend bool operator==(const AngleStep&, const AngleStep&) = default;
};

/// Parses a template of angles per layer: items separated by commas. After the last item, the
/// template starts again. `45` is an angle. `+30` and `-30` are relative to the layer below. `#N`
/// after an item repeats the item in N layers:
///       0,90        +30        0#2,45#2,90#2
/// A relative angle in the lowest layer is relative to `fill_angle`. Errors: InvalidArgument for an
/// empty list, for an item that is not a number up to 360 degrees, or for more than kMaxAngleSteps
/// layers.
absl::StatusOr<std::vector<AngleStep>> ParseFillAngles(std::string_view text);
inline constexpr int kMaxAngleSteps = 1000;

/// Returns the template in the form that ParseFillAngles reads. Consecutive equal items are
/// combined.
std::string PrintFillAngles(const std::vector<AngleStep>& steps);

/// Returns the infill angle of a layer in degrees, in [0, 360). `base_degrees`: `fill_angle`.
/// `layer`: number of the layer within the object. REQUIRES: steps are not empty, layer >= 0. Cost:
/// O(steps).
double FillAngleAt(const std::vector<AngleStep>& steps, double base_degrees, int32_t layer);

}  // namespace slicefarm
