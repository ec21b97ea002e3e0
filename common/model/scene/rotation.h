#pragma once

#include <Eigen/Core>
#include <array>

namespace slicefarm {

/// Sine and cosine of an angle.
struct SineCosine {
  double sine = 0;
  double cosine = 1;
};

/// Returns sine and cosine of an angle in degrees, to within 2e-16 and exact for multiples of 90.
/// The result has the same bits on every machine (see portable_math.h). REQUIRES: finite.
SineCosine SineCosineDegrees(double degrees);

/// Returns the rotation about x, then y, then z: Rz Ry Rx.
Eigen::Matrix3d RotationXyz(const std::array<double, 3>& degrees);

}  // namespace slicefarm
