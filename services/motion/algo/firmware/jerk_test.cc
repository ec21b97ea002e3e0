#include "services/motion/algo/firmware/jerk.h"

#include <gtest/gtest.h>

namespace slicefarm::motion::jerk_test {
namespace {

TEST(JerkLimited, PlansByItsLimitOfJerk) {
  MachineLimits limits;
  limits.jerk_mm_s3 = 1e5;
  const auto planner = JerkLimited().MakePlanner(limits);
  const KinematicMove move{40, {1, 0, 0, 0}, 100, 1000};
  EXPECT_NEAR(planner->Plan({&move, 1}).front().time_s, 0.51, 1e-9);
}

TEST(JerkLimited, ReadsMarlinsCommands) {
  EXPECT_TRUE(JerkLimited().Knows(ParseGcodeLine("M204 P500")));
  MachineLimits limits;
  JerkLimited().ApplyLimits(ParseGcodeLine("M204 P500"), limits);
  EXPECT_EQ(limits.max_acceleration_extruding_mm_s2, 500);
}

}  // namespace
}  // namespace slicefarm::motion::jerk_test
