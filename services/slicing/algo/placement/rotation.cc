#include "services/slicing/algo/placement/rotation.h"

#include <cmath>

#include "common/base/portable_math.h"

namespace slicefarm::slicing {
namespace {

Matrix3 Product(const Matrix3& a, const Matrix3& b) {
  Matrix3 product{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      product[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
  return product;
}

}  // namespace

SineCosine SineCosineDegrees(double degrees) {
  constexpr double kRadiansPerDegree = 0.017453292519943295;
  const double turn = std::fmod(degrees, 360.0);
  const double quarters = std::round(turn / 90.0);
  const double rest = (turn - 90.0 * quarters) * kRadiansPerDegree;
  const double sine = Sin(rest), cosine = Cos(rest);
  switch ((static_cast<int>(quarters) + 8) % 4) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, -sine};
    case 2:
      return {-sine, -cosine};
    default:
      return {-cosine, sine};
  }
}

Matrix3 RotationXyz(const std::array<double, 3>& degrees) {
  const auto [sx, cx] = SineCosineDegrees(degrees[0]);
  const auto [sy, cy] = SineCosineDegrees(degrees[1]);
  const auto [sz, cz] = SineCosineDegrees(degrees[2]);
  const Matrix3 about_x = {{{1, 0, 0}, {0, cx, -sx}, {0, sx, cx}}};
  const Matrix3 about_y = {{{cy, 0, sy}, {0, 1, 0}, {-sy, 0, cy}}};
  const Matrix3 about_z = {{{cz, -sz, 0}, {sz, cz, 0}, {0, 0, 1}}};
  return Product(about_z, Product(about_y, about_x));
}

}  // namespace slicefarm::slicing
