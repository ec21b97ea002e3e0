#pragma once

#include <Eigen/Core>
#include <array>

namespace slicefarm {

struct SineCosine {
  double sine = 0;
  double cosine = 1;
};

/// Sine and cosine of an angle in degrees, within 2e-16, exact for multiples of 90; the same bits
/// on every machine (see portable_math.h). REQUIRES: finite.
SineCosine SineCosineDegrees(double degrees);

/// Rotation about x, then y, then z: Rz Ry Rx.
Eigen::Matrix3d RotationXyz(const std::array<double, 3>& degrees);

}  // namespace slicefarm
