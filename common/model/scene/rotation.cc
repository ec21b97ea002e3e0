#include "common/model/scene/rotation.h"

#include <cmath>

#include "common/base/portable_math.h"

namespace slicefarm {
namespace {

Eigen::Matrix3d Rows(const std::array<std::array<double, 3>, 3>& rows) {
  Eigen::Matrix3d matrix;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) matrix(i, j) = rows[i][j];
  return matrix;
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

Eigen::Matrix3d RotationXyz(const std::array<double, 3>& degrees) {
  const auto [sx, cx] = SineCosineDegrees(degrees[0]);
  const auto [sy, cy] = SineCosineDegrees(degrees[1]);
  const auto [sz, cz] = SineCosineDegrees(degrees[2]);
  const Eigen::Matrix3d about_x = Rows({{{1, 0, 0}, {0, cx, -sx}, {0, sx, cx}}});
  const Eigen::Matrix3d about_y = Rows({{{cy, 0, sy}, {0, 1, 0}, {-sy, 0, cy}}});
  const Eigen::Matrix3d about_z = Rows({{{cz, -sz, 0}, {sz, cz, 0}, {0, 0, 1}}});
  return about_z * (about_y * about_x).eval();
}

}  // namespace slicefarm
