#pragma once

#include <array>
#include <vector>

#include "absl/status/status.h"
#include "common/geometry/point.h"
#include "common/model/scene/transform.h"

namespace slicefarm {

/// Placement of an object on the bed. The file's units are converted to mm. Then the object is
/// scaled, rotated about x, y and z in this order, and moved in z so that its bottom is at z = 0.
/// Each of `centers` is the position of the middle of one copy's bounding box.
struct Placement {
  double unit_mm = 1.0;                     ///< mm per unit of the file
  std::array<double, 3> scale = {1, 1, 1};  ///< scale factors, above 0
  std::array<double, 3> rotate_deg = {0, 0, 0};
  std::vector<Point> centers = {};  ///< position of each copy; empty: one copy at any free position

  friend bool operator==(const Placement&, const Placement&) = default;
};

/// Checks that units, scale and angles are finite, and units and scale above zero. Errors:
/// SETTING_OUT_OF_RANGE.
absl::Status CheckPlacement(const Placement& placement);

/// Returns the transform from the file's units to millimetres, without a shift. Sines are computed
/// only with + and *, so they have the same bits on every machine. Rotations by right angles are
/// exact.
Transform TransformOf(const Placement& placement);

}  // namespace slicefarm
