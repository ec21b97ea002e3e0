#pragma once

#include <Eigen/Core>

namespace slicefarm {

/// Affine map of millimetres to millimetres: a 3x3 matrix, with the shift in the last column.
using Transform = Eigen::Matrix<double, 3, 4>;

/// Returns the map that applies `first`, then `second`.
inline Transform Combined(const Transform& second, const Transform& first) {
  Transform both = second.leftCols<3>() * first;
  both.col(3) += second.col(3);
  return both;
}

}  // namespace slicefarm
