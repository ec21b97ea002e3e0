#include "common/kinematics/klipper_planner.h"

#include <gtest/gtest.h>

#include <cmath>

namespace slicefarm::klipper_planner_test {
namespace {

/// 0.8 mm of filament at 35 mm/s with a toolhead of 3000 mm/s^2 and an extruder of 1500. The peak
/// is the speed reached with the smaller of half of 3000 and 1500.
TEST(KlipperPlanner, TheToolheadsCruiseRatioHoldsForRetractions) {
  KlipperPlanner planner(MachineLimits{});
  const KinematicMove retract{0.8, {0, 0, 0, -1}, 35, 3000};
  EXPECT_NEAR(planner.Plan({&retract, 1}).front().cruise_mm_s, std::sqrt(1500 * 0.8), 1e-9);
  const KinematicMove slow{0.8, {0, 0, 0, -1}, 35, 1000};
  EXPECT_NEAR(planner.Plan({&slow, 1}).front().cruise_mm_s, std::sqrt(500 * 0.8), 1e-9);
}

TEST(KlipperPlanner, WipesWhileRetractingAreTheExtrudersToLimit) {
  KlipperPlanner planner(MachineLimits{});  // the extruder: 120 mm/s, 1500 mm/s^2
  const KinematicMove wipe{10, {0.8, 0.6, 0, -2}, 150, 3000};
  const KinematicMove limited = planner.Limited(wipe);
  EXPECT_DOUBLE_EQ(limited.speed_mm_s, 60);
  EXPECT_DOUBLE_EQ(limited.acceleration_mm_s2, 750);
}

TEST(KlipperPlanner, LimitsMayChangeOnTheWay) {
  // Each corner has the square corner velocity of the slower of its two moves.
  MachineLimits limits;
  limits.max_feedrate_mm_s = {300, 300, 20, 120};
  KlipperPlanner planner(limits);
  planner.Add({50, {1, 0, 0, 0}, 100, 3000});
  limits.square_corner_velocity_mm_s = 3;
  planner.SetLimits(limits);
  planner.Add({50, {0, 1, 0, 0}, 100, 3000});
  const auto profiles = planner.Stop();
  EXPECT_NEAR(profiles[0].exit_mm_s, 3, 1e-9);
  EXPECT_TRUE(planner.Stop().empty());
}

}  // namespace
}  // namespace slicefarm::klipper_planner_test
