#include "common/kinematics/two_pass_planner.h"

#include <gtest/gtest.h>

#include <cmath>

namespace slicefarm::two_pass_planner_test {
namespace {

constexpr TwoPassPlanner::Rules kFixed = {
    [](KinematicMove move, const MachineLimits&) { return move; },
    [](const KinematicMove&, const MachineLimits&) { return 0.0; },
    [](const KinematicMove&, const KinematicMove&, const MachineLimits&) { return 1e4; }, 0};

TEST(TwoPassPlanner, BothPassesLowerJunctions) {
  TwoPassPlanner planner(kFixed, {});
  // The greatest changes of the squared speed, 2 a L, are 200, 2000 and 100.
  planner.Add({0.1, {1, 0, 0, 0}, 100, 1000});
  planner.Add({1, {1, 0, 0, 0}, 100, 1000});
  planner.Add({0.05, {1, 0, 0, 0}, 100, 1000});
  const auto profiles = planner.Stop();
  EXPECT_NEAR(profiles[0].exit_mm_s, std::sqrt(200), 1e-9) << "forward";
  EXPECT_NEAR(profiles[1].exit_mm_s, std::sqrt(100), 1e-9) << "backward";
  EXPECT_NEAR(profiles[1].cruise_mm_s, std::sqrt((200 + 100 + 2000) / 2.0), 1e-9);
}

}  // namespace
}  // namespace slicefarm::two_pass_planner_test
