#include "services/motion/algo/toolpath/arc_chords.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace slicefarm::motion::arc_chords_test {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Arc, Angles) {
  EXPECT_NEAR((Arc{{1, 0}, {0, 1}, {0, 0}, false}.Angle()), kPi / 2, 1e-12);
  EXPECT_NEAR((Arc{{1, 0}, {0, 1}, {0, 0}, true}.Angle()), 3 * kPi / 2, 1e-12);
  EXPECT_NEAR((Arc{{1, 0}, {1, 0}, {0, 0}, true}.Angle()), 2 * kPi, 1e-12);
}

TEST(Arc, Radii) {
  const Arc arc{{3, 4}, {0, 6}, {0, 0}, false};
  EXPECT_DOUBLE_EQ(arc.StartRadius(), 5);
  EXPECT_DOUBLE_EQ(arc.EndRadius(), 6);
}

TEST(CentreByRadius, TheShorterOrTheLongerWay) {
  for (const bool clockwise : {false, true}) {
    for (const double radius : {5.0, -5.0}) {
      Arc arc{{0, 0}, {6, 0}, CentreByRadius({0, 0}, {6, 0}, radius, clockwise), clockwise};
      EXPECT_NEAR(arc.StartRadius(), 5, 1e-12);
      EXPECT_NEAR(arc.EndRadius(), 5, 1e-12);
      EXPECT_EQ(arc.Angle() < kPi, radius > 0);
    }
  }
}

TEST(ArcChords, LieOnTheArcAndEndAtItsEnd) {
  const Arc arc{{10, 0}, {-10, 0.001}, {0, 0}, false};
  const auto ends = ArcChords(arc, 10 * arc.Angle(), 1);
  ASSERT_EQ(ends.size(), 31);
  EXPECT_EQ(ends.back(), arc.to);
  for (const Vector2& end : ends) {
    EXPECT_NEAR(std::hypot(end.x(), end.y()), 10, 1e-6);
    EXPECT_GE(end.y(), 0) << "counter-clockwise";
  }
  EXPECT_EQ(ArcChords(arc, 0.5, 1).size(), 1) << "shorter than a chord";
}

}  // namespace
}  // namespace slicefarm::motion::arc_chords_test
