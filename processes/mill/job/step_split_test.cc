#include "processes/mill/job/step_split.h"

#include <gtest/gtest.h>

#include <numeric>

namespace slicefarm::coordinator::step_split_test {
namespace {

MillLayout Layout(int roughing, int finishing, int rows) {
  MillLayout layout;
  layout.steps.insert(layout.steps.end(), roughing, {MillPhase::kRoughing, 1});
  layout.steps.insert(layout.steps.end(), finishing, {MillPhase::kFinishing, 1});
  layout.steps.insert(layout.steps.end(), rows, {MillPhase::kRest, 1});
  for (const MillStep& step : layout.steps)
    layout.weights.push_back(step.phase == MillPhase::kRoughing ? 4 : 1);
  return layout;
}

TEST(SplitSteps, CoversAllStepsPhaseByPhase) {
  const Shared<MillInput> input;
  for (const MillLayout& layout :
       {Layout(1, 0, 0), Layout(40, 90, 300), Layout(0, 0, 7), Layout(1000, 4000, 20'000)}) {
    for (const int slots : {0, 1, 2, 8, 300}) {
      int32_t next = 0;
      int64_t weight = 0;
      for (const MillTask& task : SplitSteps(layout, input, slots)) {
        EXPECT_EQ(task.steps.first, next);
        ASSERT_GT(task.steps.size(), 0);
        next = task.steps.last;
        weight += task.weight;
        EXPECT_LE(task.weight, 404);
        EXPECT_EQ(&*task.input, &*input);
        for (int32_t i = task.steps.first; i < task.steps.last; ++i)
          EXPECT_EQ(layout.steps[static_cast<size_t>(i)].phase, task.phase);
        const auto before = static_cast<size_t>(task.steps.first - task.phase_first);
        EXPECT_EQ(layout.steps[before].phase, task.phase);
        EXPECT_TRUE(before == 0 || layout.steps[before - 1].phase != task.phase);
      }
      EXPECT_EQ(next, std::ssize(layout.steps));
      EXPECT_EQ(weight, std::accumulate(layout.weights.begin(), layout.weights.end(), int64_t{0}));
    }
  }
}

TEST(SplitSteps, GivesEachSlotTwo) {
  EXPECT_EQ(SplitSteps(Layout(40, 0, 0), {}, 1).size(), 2u);
  EXPECT_EQ(SplitSteps(Layout(40, 0, 0), {}, 4).size(), 8u);
  EXPECT_EQ(SplitSteps(Layout(0, 0, 20), {}, 8).size(), 2u)
      << "small ranges cost more than they gain";
}

}  // namespace
}  // namespace slicefarm::coordinator::step_split_test
