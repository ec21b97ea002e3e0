#include "common/kinematics/marlin_junction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slicefarm::marlin_junction_test {
namespace {

constexpr double kPi = std::numbers::pi;

KinematicMove Towards(double angle_rad, double length_mm = 10, double speed_mm_s = 100) {
  return {length_mm, {std::cos(angle_rad), std::sin(angle_rad), 0, 0}, speed_mm_s, 1000};
}

MachineLimits Limits() {
  MachineLimits limits;
  limits.max_feedrate_mm_s = {300, 300, 20, 120};
  limits.max_acceleration_mm_s2 = {3000, 3000, 500, 3000};
  limits.max_jerk_mm_s = {8, 8, 0.4, 2.5};
  limits.junction_deviation_mm = 0.02;
  return limits;
}

TEST(LimitedByMarlin, NothingIsSlowerThanTheLeastRates) {
  MachineLimits limits = Limits();
  limits.min_extruding_rate_mm_s = 5;
  limits.min_travel_rate_mm_s = 7;
  EXPECT_EQ(LimitedByMarlin({10, {1, 0, 0, 0.03}, 2, 1000}, limits).speed_mm_s, 5);
  EXPECT_EQ(LimitedByMarlin({10, {1, 0, 0, 0}, 2, 1000}, limits).speed_mm_s, 7);
  EXPECT_EQ(LimitedByMarlin({10, {1, 0, 0, 0}, 9, 1000}, limits).speed_mm_s, 9);
}

TEST(LimitedByMarlin, EachAxisHasItsLimits) {
  KinematicMove up{10, {0, 0, 1, 0}, 100, 1000};
  EXPECT_EQ(LimitedByMarlin(up, Limits()).speed_mm_s, 20);
  EXPECT_EQ(LimitedByMarlin(up, Limits()).acceleration_mm_s2, 500);
  const KinematicMove slope{10, {0.8, 0, 0.6, 0}, 100, 1000};
  EXPECT_DOUBLE_EQ(LimitedByMarlin(slope, Limits()).speed_mm_s, 20 / 0.6);
  const KinematicMove thick{10, {1, 0, 0, 4}, 100, 1000};
  EXPECT_DOUBLE_EQ(LimitedByMarlin(thick, Limits()).speed_mm_s, 30);
  EXPECT_DOUBLE_EQ(LimitedByMarlin(thick, Limits()).acceleration_mm_s2, 750);
}

TEST(LimitedByMarlin, ZeroIsNoLimit) {
  MachineLimits limits = Limits();
  limits.max_feedrate_mm_s = {};
  limits.max_acceleration_mm_s2 = {};
  const KinematicMove move = LimitedByMarlin(Towards(0), limits);
  EXPECT_EQ(move.speed_mm_s, 100);
  EXPECT_EQ(move.acceleration_mm_s2, 1000);
}

TEST(JunctionDeviation, RightAngle) {
  // s = sin 45 degrees: v^2 = 1000 * 0.02 * 0.70711 / 0.29289.
  EXPECT_NEAR(JunctionDeviationV2(Towards(0), Towards(kPi / 2), Limits()), 48.28427, 1e-4);
}

TEST(JunctionDeviation, SixtyDegrees) {
  // The angle between the moves is 120 degrees: s = sin 60 degrees.
  const double s = std::sin(kPi / 3);
  EXPECT_NEAR(JunctionDeviationV2(Towards(0), Towards(kPi / 3), Limits()), 20 * s / (1 - s), 1e-9);
}

TEST(JunctionDeviation, StraightOnIsNotLimitedAndBackIsAStop) {
  EXPECT_DOUBLE_EQ(JunctionDeviationV2(Towards(0), Towards(0, 10, 70), Limits()), 4900);
  EXPECT_DOUBLE_EQ(JunctionDeviationV2(Towards(0), Towards(kPi), Limits()), 0.05 * 0.05);
}

TEST(JunctionDeviation, ShortMovesGoRoundAnArc) {
  const double turn = kPi / 18;  // 10 degrees
  EXPECT_NEAR(JunctionDeviationV2(Towards(0, 0.5), Towards(turn, 0.5), Limits()), 0.5 * 1000 / turn,
              1e-6);
}

TEST(JunctionDeviation, WeakAxisLowersTheAcceleration) {
  MachineLimits limits = Limits();
  limits.max_acceleration_mm_s2[kX] = 100;
  // In the direction of the change, (-1, 1) / sqrt(2), the axes allow 141 mm/s^2.
  EXPECT_NEAR(JunctionDeviationV2(Towards(0), Towards(kPi / 2), limits), 0.14142136 * 48.28427,
              1e-4);
}

TEST(ClassicJerk, RightAngleIsTheJerkOfOneAxis) {
  EXPECT_NEAR(ClassicJerkSpeed(Towards(0), Towards(kPi / 2), Limits()), 8, 1e-9);
}

TEST(ClassicJerk, StraightOnIsNotLimited) {
  EXPECT_NEAR(ClassicJerkSpeed(Towards(0), Towards(0, 10, 40), Limits()), 40, 1e-9);
}

TEST(ClassicJerk, SmallTurn) {
  // x changes by v (1 - cos), y by v sin: the change of y is decisive.
  const double turn = kPi / 18;
  EXPECT_NEAR(ClassicJerkSpeed(Towards(0), Towards(turn), Limits()), 8 / std::sin(turn), 1e-9);
}

TEST(ClassicJerk, TurningBackStopsAtTheSafeSpeed) {
  EXPECT_NEAR(ClassicJerkSpeed(Towards(0), Towards(kPi), Limits()), 8, 1e-9);
  EXPECT_NEAR(SafeSpeed(Towards(kPi / 4), Limits()), 8 * std::numbers::sqrt2, 1e-9);
}

TEST(ClassicJerk, RetractionAfterABead) {
  const KinematicMove bead{10, {1, 0, 0, 0.03}, 60, 1000};
  const KinematicMove retract{0.8, {0, 0, 0, -1}, 35, 1500};
  EXPECT_NEAR(SafeSpeed(retract, Limits()), 2.5, 1e-9);
  EXPECT_LE(ClassicJerkSpeed(bead, retract, Limits()), 2.5 + 1e-9);
}

// For any directions, no axis jumps by more than its limit, or the move starts at its safe speed.
// An axis that reverses counts as a stop and a new start.
TEST(ClassicJerk, NoAxisJumpsTooFar) {
  for (int i = 0; i < 72; ++i) {
    const KinematicMove in = Towards(0.3);
    const KinematicMove out = Towards(0.3 + i * kPi / 36);
    const double v = ClassicJerkSpeed(in, out, Limits());
    for (const Axis axis : {kX, kY}) {
      const double exit = v * in.ratio[axis];
      const double entry = v * out.ratio[axis];
      const double change =
          exit * entry < 0 ? std::max(std::abs(exit), std::abs(entry)) : std::abs(exit - entry);
      const bool jump = change <= 8 + 1e-9;
      const bool safe = v <= SafeSpeed(out, Limits()) + 1e-9;
      EXPECT_TRUE(jump || safe) << i;
    }
  }
}

}  // namespace
}  // namespace slicefarm::marlin_junction_test
