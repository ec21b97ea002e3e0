#include "common/kinematics/axis_limits.h"

#include <cmath>
#include <cstddef>

namespace slicefarm {

double LimitedByAxes(double value, const std::array<double, 4>& ratio,
                     const std::array<double, 4>& limits) {
  for (size_t axis = 0; axis < ratio.size(); ++axis) {
    const double share = std::abs(ratio[axis]);
    if (limits[axis] > 0 && share * value > limits[axis]) value = limits[axis] / share;
  }
  return value;
}

}  // namespace slicefarm
