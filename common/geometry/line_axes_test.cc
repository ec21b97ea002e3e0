#include "common/geometry/line_axes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace slicefarm::line_axes_test {
namespace {

TEST(LineAxes, RightAnglesAreExact) {
  const Point p{123'456'789, -987'654'321};
  for (int quarter = -5; quarter < 6; ++quarter) {
    const LineAxes frame = LineAxes::OfDegrees(90.0 * quarter);
    EXPECT_EQ(frame.At(frame.U(p), frame.V(p)), p);
    EXPECT_EQ(std::abs(frame.U(p)), quarter % 2 == 0 ? 123'456'789 : 987'654'321);
  }
}

TEST(LineAxes, TurnsThereAndBack) {
  const Point p{12'345'678, -9'876'543};
  for (double angle_deg = -725; angle_deg < 725; angle_deg += 13.7) {
    const LineAxes frame = LineAxes::OfDegrees(angle_deg);
    const Point back = frame.At(frame.U(p), frame.V(p));
    EXPECT_LE(std::abs(back.x - p.x), 1) << angle_deg;
    EXPECT_LE(std::abs(back.y - p.y), 1) << angle_deg;
    const LineAxes same(angle_deg * std::numbers::pi / 180);
    EXPECT_NEAR(frame.U(p), same.U(p), 1e-3) << angle_deg;
  }
}

TEST(LineAxes, RoundsHalvesAwayFromZero) {
  const LineAxes frame(0);
  EXPECT_EQ(frame.At(0.5, -0.5), (Point{1, -1}));
  EXPECT_EQ(frame.At(1.49, -1.49), (Point{1, -1}));
}

}  // namespace
}  // namespace slicefarm::line_axes_test
