#include "common/kinematics/trapezoid.h"

#include <gtest/gtest.h>

#include <cmath>

namespace slicefarm::trapezoid_test {
namespace {

KinematicMove Line(double length_mm, double speed_mm_s = 100, double acceleration_mm_s2 = 3000) {
  return {length_mm, {1, 0, 0, 0}, speed_mm_s, acceleration_mm_s2};
}

TEST(RestToRest, HundredMillimetres) {
  // 1/30 s acceleration, 1/30 s deceleration over 10/3 mm, the rest at 100 mm/s.
  EXPECT_NEAR(RestToRest(100, 100, 3000), 1.033333333333, 1e-12);
}

TEST(RestToRest, TooShortToCruise) {
  // The speed is at most sqrt(3000 * 1 mm) = 54.77 mm/s.
  EXPECT_NEAR(RestToRest(1, 100, 3000), 2 * std::sqrt(1.0 / 3000), 1e-12);
  EXPECT_EQ(RestToRest(0, 100, 3000), 0);
}

TEST(Trapezoid, ThroughACorner) {
  EXPECT_NEAR(Trapezoid(Line(100), 0, 1e4, 25).time_s, 1.031708333333, 1e-12);
  EXPECT_NEAR(Trapezoid(Line(100), 25, 1e4, 0).time_s, 1.031708333333, 1e-12);
  EXPECT_NEAR(Trapezoid(Line(100), 10.862 * 10.862, 1e4, 25).time_s, 1.028284, 1e-6);
}

TEST(Trapezoid, OnlySpeedsUp) {
  const MoveProfile profile = Trapezoid(Line(0.5), 0, 1e4, 3000);
  EXPECT_NEAR(profile.cruise_mm_s, std::sqrt(3000), 1e-9);
  EXPECT_NEAR(profile.time_s, std::sqrt(3000) / 3000, 1e-12);
}

TEST(Trapezoid, AtOneSpeed) { EXPECT_NEAR(Trapezoid(Line(20), 1e4, 1e4, 1e4).time_s, 0.2, 1e-12); }

}  // namespace
}  // namespace slicefarm::trapezoid_test
