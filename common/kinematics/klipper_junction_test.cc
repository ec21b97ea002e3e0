#include "common/kinematics/klipper_junction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace slicefarm::klipper_junction_test {
namespace {

constexpr double kPi = std::numbers::pi;

KinematicMove Towards(double angle_rad, double length_mm = 100, double e = 0) {
  return {length_mm, {std::cos(angle_rad), std::sin(angle_rad), 0, e}, 100, 3000};
}

double V2(const KinematicMove& before, const KinematicMove& move,
          const MachineLimits& limits = {}) {
  return KlipperJunctionV2(LimitedByKlipper(before, limits), LimitedByKlipper(move, limits));
}

double V(const KinematicMove& before, const KinematicMove& move) {
  return std::sqrt(V2(before, move));
}

TEST(KlipperJunction, SquareCornerVelocity) {
  EXPECT_NEAR(V(Towards(0), Towards(kPi / 2)), 5, 1e-9);
  MachineLimits limits;
  limits.square_corner_velocity_mm_s = 8;
  EXPECT_NEAR(V2(Towards(0), Towards(kPi / 2), limits), 64, 1e-9);
}

TEST(KlipperJunction, FollowsTheAngle) {
  // v^2 = scv^2 (sqrt 2 - 1) s / (1 - s), s = sin of half the inner angle.
  for (const double turn : {0.1, 0.5, 1.0, 2.0, 3.0}) {
    const double s = std::cos(turn / 2);
    const double want = 25 * (std::numbers::sqrt2 - 1) * s / (1 - s);
    EXPECT_NEAR(V2(Towards(0), Towards(turn)), std::min(want, 1e4), 1e-6);
  }
}

TEST(KlipperJunction, StraightAndBack) {
  EXPECT_DOUBLE_EQ(V(Towards(0.7), Towards(0.7)), 100);
  EXPECT_NEAR(V(Towards(0), Towards(kPi)), 0, 1e-6);
}

TEST(KlipperJunction, ShortMovesLimitTheArc) {
  const double turn = 0.2;
  const double tan_half = std::cos(turn / 2) / std::sin(turn / 2);
  EXPECT_NEAR(V2(Towards(0, 0.05), Towards(turn)), 0.5 * 0.05 * 3000 * tan_half, 1e-6);
}

TEST(KlipperJunction, ExtruderCornersAtOneMillimetrePerSecond) {
  EXPECT_NEAR(V(Towards(0, 100, 0.05), Towards(0, 100, 0)), 20, 1e-9);
  EXPECT_NEAR(V(Towards(0, 100, 0.05), Towards(0, 100, 0.04)), 100, 1e-9);
}

TEST(KlipperJunction, TheZAxisLowersTheCorner) {
  const MachineLimits limits;  // z: 500 mm/s^2
  const KinematicMove up{100, {0, 0, 1, 0}, 20, 3000};
  EXPECT_NEAR(V2(up, Towards(0), limits), 25.0 / 6, 1e-9);
}

TEST(KlipperJunction, TheExtruderAloneStops) {
  const KinematicMove retract{0.8, {0, 0, 0, -1}, 35, 1500};
  EXPECT_EQ(V(Towards(0), retract), 0);
  EXPECT_EQ(V(retract, Towards(0)), 0);
}

TEST(LimitedByKlipper, SpeedsAndTheShareOfZ) {
  MachineLimits limits;
  limits.max_feedrate_mm_s = {80, 90, 20, 40};
  EXPECT_EQ(LimitedByKlipper(Towards(0), limits).speed_mm_s, 80);
  const KinematicMove slope{10, {0.8, 0, 0.6, 0}, 70, 3000};
  EXPECT_DOUBLE_EQ(LimitedByKlipper(slope, limits).speed_mm_s, 20 / 0.6);
  EXPECT_DOUBLE_EQ(LimitedByKlipper(slope, limits).acceleration_mm_s2, 500 / 0.6);
  const KinematicMove retract{0.8, {0, 0, 0, -1}, 50, 1000};
  EXPECT_EQ(LimitedByKlipper(retract, limits).speed_mm_s, 40);
  EXPECT_EQ(LimitedByKlipper(retract, limits).acceleration_mm_s2, 1500);
}

}  // namespace
}  // namespace slicefarm::klipper_junction_test
