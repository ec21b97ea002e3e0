#include "processes/mill/task/mill_task.h"

#include <gtest/gtest.h>

namespace slicefarm::mill_task_test {
namespace {

TEST(MillTask, SaysWhatItMills) {
  struct Case {
    MillTask task;
    const char* label;
  };
  for (const Case& c : {
           Case{{{4, 5}, MillPhase::kRoughing, 4, 7, {}}, "roughing level 4"},
           Case{{{10, 17}, MillPhase::kFinishing, 3, 7, {}}, "finishing levels 3 to 9"},
           Case{{{110, 141}, MillPhase::kRest, 10, 7, {}}, "rest rows 10 to 40"},
       }) {
    const Task any = c.task;
    EXPECT_EQ(any.process(), Process::kMill);
    EXPECT_EQ(any.weight(), 7);
    EXPECT_EQ(any.label().text, c.label);
    EXPECT_EQ(any.label().numbers.at("step_first"), c.task.steps.first);
    EXPECT_EQ(any.label().numbers.at("step_last"), c.task.steps.last - 1);
  }
}

TEST(MillResult, HasTheSamePrintIfItsStepsAreTheSame) {
  MillResult a;
  a.steps = {
      {{MillPhase::kRoughing, 2}, {{{{{0, 0}, {9, 0}, {0, 9}}, {}}, {{{1, 1}, {2, 1}}}}}, {}},
      {{MillPhase::kRest, -1}, {}, {{{0, -1, 2}, {1, -1, 3}}}}};
  MillResult b = a;
  b.times[Stage::kMilling] = 3;
  EXPECT_EQ(a.Print(), b.Print());
  EXPECT_EQ(a.ProgramBytes(), 80);
  b.steps[0].areas[0].passes[0][1].y = 2;
  EXPECT_NE(a.Print(), b.Print());
  b = a;
  b.steps[1].runs[0][1].z() = 2.5;
  EXPECT_NE(a.Print(), b.Print());
  b = a;
  b.steps[0].step.at_mm = 1;
  EXPECT_NE(a.Print(), b.Print());
}

}  // namespace
}  // namespace slicefarm::mill_task_test
