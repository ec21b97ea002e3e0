#include "common/model/scene/rotation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace slicefarm::rotation_test {
namespace {

TEST(SineCosine, RightAnglesAreExact) {
  const double want[4][2] = {{0, 1}, {1, 0}, {0, -1}, {-1, 0}};
  for (int quarter = -9; quarter <= 9; ++quarter) {
    const SineCosine got = SineCosineDegrees(90.0 * quarter);
    EXPECT_EQ(got.sine, want[(quarter + 12) % 4][0]) << quarter;
    EXPECT_EQ(got.cosine, want[(quarter + 12) % 4][1]) << quarter;
  }
}

TEST(SineCosine, AgreesWithTheLibraryTo2Em16) {
  for (int i = -3600; i <= 3600; ++i) {
    const double degrees = 0.1 * i, radians = degrees * std::numbers::pi / 180;
    EXPECT_NEAR(SineCosineDegrees(degrees).sine, std::sin(radians),
                4e-16 * (1 + std::abs(radians)));
    EXPECT_NEAR(SineCosineDegrees(degrees).cosine, std::cos(radians),
                4e-16 * (1 + std::abs(radians)));
  }
}

TEST(SineCosine, IsOddAndEven) {
  for (double degrees = 0.3; degrees < 400; degrees += 7.7) {
    EXPECT_EQ(SineCosineDegrees(-degrees).sine, -SineCosineDegrees(degrees).sine);
    EXPECT_EQ(SineCosineDegrees(-degrees).cosine, SineCosineDegrees(degrees).cosine);
  }
}

TEST(RotationXyz, TurnsAboutXThenYThenZ) {
  // The rotation about x moves y to z; about y, z to x; about z, x to y.
  const Eigen::Matrix3d m = RotationXyz({90, 90, 90});
  const double y_axis[3] = {m(0, 1), m(1, 1), m(2, 1)};
  EXPECT_EQ(y_axis[0], 0);
  EXPECT_EQ(y_axis[1], 1);
  EXPECT_EQ(y_axis[2], 0);
}

TEST(RotationXyz, NoTurnIsTheIdentity) {
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  EXPECT_EQ(RotationXyz({0, 0, 0}), identity);
  EXPECT_EQ(RotationXyz({360, -720, 0}), identity);
}

}  // namespace
}  // namespace slicefarm::rotation_test
