#pragma once

#include <array>
#include <vector>

#include "absl/status/status.h"
#include "common/geometry/point.h"
#include "common/model/scene/transform.h"

namespace slicefarm {

/// How an object comes to lie on the bed: units, then scale, then rotation about x, y, z in this
/// order; the result drops onto z = 0 with the middle of its bounding box over each of `centers`.
struct Placement {
  double unit_mm = 1.0;                     ///< mm per unit of the file
  std::array<double, 3> scale = {1, 1, 1};  ///< > 0
  std::array<double, 3> rotate_deg = {0, 0, 0};
  std::vector<Point> centers = {};  ///< one per copy; empty: one copy, wherever there is room

  friend bool operator==(const Placement&, const Placement&) = default;
};

/// Errors: SETTING_OUT_OF_RANGE for units, scale or angles that are not finite, or not above zero.
absl::Status CheckPlacement(const Placement& placement);

/// From the units of the file to millimetres, without a shift. The rotation's sines are computed
/// from + and * alone, so they have the same bits on every machine, and right angles are exact.
Transform TransformOf(const Placement& placement);

}  // namespace slicefarm
