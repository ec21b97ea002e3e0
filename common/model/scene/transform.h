#pragma once

#include <Eigen/Core>

namespace slicefarm {

/// An affine map of millimetres to millimetres: a 3x3 matrix, and a shift in the last column.
using Transform = Eigen::Matrix<double, 3, 4>;

/// `second` after `first`.
inline Transform Combined(const Transform& second, const Transform& first) {
  Transform both = second.leftCols<3>() * first;
  both.col(3) += second.col(3);
  return both;
}

}  // namespace slicefarm
