#include "common/kinematics/reprap_planner.h"

#include <gtest/gtest.h>

#include "common/kinematics/trapezoid.h"

namespace slicefarm::reprap_planner_test {
namespace {

TEST(RepRapPlanner, StopsBetweenPrintingAndTravel) {
  RepRapPlanner planner(MachineLimits{});
  planner.Add({50, {1, 0, 0, 0.03}, 100, 3000});
  planner.Add({50, {1, 0, 0, 0}, 100, 3000});
  const auto profiles = planner.Stop();
  EXPECT_NEAR(profiles[0].time_s + profiles[1].time_s, 2 * RestToRest(50, 100, 3000), 1e-9);
}

TEST(RepRapPlanner, CornersByTheJerkOfTheAxes) {
  RepRapPlanner planner(MachineLimits{});  // jerk: 8 mm/s
  planner.Add({50, {1, 0, 0, 0}, 100, 3000});
  planner.Add({50, {0, 1, 0, 0}, 100, 3000});
  EXPECT_NEAR(planner.Stop()[0].exit_mm_s, 8, 1e-9);
}

}  // namespace
}  // namespace slicefarm::reprap_planner_test
