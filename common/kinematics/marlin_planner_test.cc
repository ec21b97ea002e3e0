#include "common/kinematics/marlin_planner.h"

#include <gtest/gtest.h>

#include "common/kinematics/marlin_junction.h"

namespace slicefarm::marlin_planner_test {
namespace {

TEST(MarlinPlanner, JerkOrJunctionDeviation) {
  MachineLimits limits;
  const KinematicMove line{100, {1, 0, 0, 0}, 100, 1000};
  MarlinPlanner jerk(limits);
  EXPECT_DOUBLE_EQ(jerk.Plan({&line, 1}).front().entry_mm_s, 8);
  limits.junction_deviation_mm = 0.02;
  MarlinPlanner deviation(limits);
  EXPECT_DOUBLE_EQ(deviation.Plan({&line, 1}).front().entry_mm_s, 0);
  EXPECT_NEAR(deviation.Plan({&line, 1}).front().exit_mm_s, kMarlinRestMmS, 1e-12);
}

TEST(MarlinPlanner, LimitsOfEachAxis) {
  MarlinPlanner planner(MachineLimits{});
  const KinematicMove up{10, {0, 0, 1, 0}, 100, 3000};
  EXPECT_EQ(planner.Limited(up).speed_mm_s, 20);
  EXPECT_EQ(planner.Limited(up).acceleration_mm_s2, 500);
}

}  // namespace
}  // namespace slicefarm::marlin_planner_test
