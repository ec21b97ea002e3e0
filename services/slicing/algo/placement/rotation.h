#pragma once

#include <array>

namespace slicefarm::slicing {

using Matrix3 = std::array<std::array<double, 3>, 3>;

struct SineCosine {
  double sine = 0;
  double cosine = 1;
};

/// Sine and cosine of an angle in degrees, within 2e-16, exact for multiples of 90; the same bits
/// on every machine (see portable_math.h). REQUIRES: finite.
SineCosine SineCosineDegrees(double degrees);

/// Rotation about x, then y, then z: Rz Ry Rx.
Matrix3 RotationXyz(const std::array<double, 3>& degrees);

}  // namespace slicefarm::slicing
