#include "common/kinematics/jerk_junction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace slicefarm::jerk_junction_test {
namespace {

KinematicMove Towards(double angle_rad, double length_mm) {
  return {length_mm, {std::cos(angle_rad), std::sin(angle_rad), 0, 0}, 100, 1000};
}

struct Case {
  double curvature, change, acceleration, jerk, want;
};

// The corrected jerk formula: sqrt(a / k) and (j / sqrt(k'^2 + k^4))^(1/3).
TEST(SpeedThrough, ObeysAccelerationAndJerk) {
  for (const Case& c : {Case{0.1, 0, 1e3, 1e5, 100}, Case{10, 0, 1e3, 1e5, 10},
                        Case{100, 0, 1e3, 1e5, 2.1544347}, Case{0, 0.001, 1e3, 1e5, 464.1588834},
                        Case{0.1, 0.2, 1e9, 1e5, std::cbrt(1e5 / std::hypot(0.2, 0.01))}}) {
    const double got = SpeedThrough({.curvature = c.curvature}, c.change, {c.acceleration, c.jerk});
    EXPECT_NEAR(got, c.want, 1e-6 * c.want) << c.curvature;
  }
  // A circle of 10 mm at 100 mm/s needs a jerk of 1e4.
  EXPECT_NEAR(SpeedThrough({.curvature = 0.1}, 0, {1e9, 1e4}), 100, 1e-9);
  EXPECT_NEAR(SpeedThrough({.curvature = 0.1}, 0, {1e9, 1e5}), 215.4434690, 1e-6);
}

TEST(SpeedThrough, StraightOnAndNoWayThrough) {
  EXPECT_EQ(SpeedThrough({}, 0, {1e3, 1e5}), std::numeric_limits<double>::infinity());
  EXPECT_EQ(SpeedThrough({.stop = true}, 0, {1e3, 1e5}), 0);
}

TEST(BendBetween, ChordsOfACircleHaveItsCurvature) {
  const double radius = 10, turn = 0.01;
  const double chord = 2 * radius * std::sin(turn / 2);
  const Bend bend = BendBetween(Towards(0, chord), Towards(turn, chord), 0.01);
  EXPECT_NEAR(bend.curvature, 1 / radius, 1e-9);
  EXPECT_LT(bend.corner, bend.curvature) << "finer than the deviation";
  EXPECT_FALSE(bend.sharp);
}

TEST(BendBetween, CornersAreCutByTheDeviation) {
  const Bend bend = BendBetween(Towards(0, 50), Towards(std::acos(0.0), 50), 0.01);
  EXPECT_TRUE(bend.sharp);
  EXPECT_NEAR(1 / bend.corner, 0.01 / (std::sqrt(2) - 1), 1e-9);
  EXPECT_GT(bend.corner, bend.curvature);
}

TEST(BendBetween, ThereIsNoWayBackOrIntoFilament) {
  EXPECT_TRUE(BendBetween({5, {1, 0, 0, 0}}, {5, {-1, 0, 0, 0}}, 0.01).stop);
  EXPECT_TRUE(BendBetween({5, {1, 0, 0, 0}}, {5, {0, 0, 0, 1}}, 0.01).stop);
}

}  // namespace
}  // namespace slicefarm::jerk_junction_test
