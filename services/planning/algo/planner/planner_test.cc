#include "services/planning/algo/planner/planner.h"

#include <gtest/gtest.h>

namespace slicefarm::planning::planner_test {
namespace {

TEST(PlanOf, FindsOrMakesByAscendingObject) {
  LayerPlan plan;
  PlanOf(4, plan).entry = {4, 4};
  PlanOf(1, plan).entry = {1, 1};
  PlanOf(9, plan).entry = {9, 9};
  EXPECT_EQ(PlanOf(4, plan).entry, (Point{4, 4}));
  ASSERT_EQ(plan.sections.size(), 3u);
  for (size_t i = 1; i < 3; ++i) EXPECT_LT(plan.sections[i - 1].stack, plan.sections[i].stack);
}

}  // namespace
}  // namespace slicefarm::planning::planner_test
