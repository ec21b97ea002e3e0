#include "processes/laser/task/laser_task.h"

#include <gtest/gtest.h>

namespace slicefarm::laser_task_test {
namespace {

TEST(LaserTask, WeighsItsLayers) {
  LaserTask task;
  task.range = {3, 5};
  const Task any = task;
  EXPECT_EQ(any.process(), Process::kLaser);
  EXPECT_EQ(any.weight(), 2);
  EXPECT_EQ(any.label().text, "layers 3 to 4");
}

TEST(LaserResult, HasTheSamePrintIfItsProgramsAreTheSame) {
  LaserResult a;
  a.programs.resize(1);
  LaserResult b = a;
  EXPECT_EQ(a.Print(), b.Print());
  b.programs[0].text = "x";
  EXPECT_NE(a.Print(), b.Print());
  EXPECT_EQ(b.ProgramBytes(), 1);
  b = a;
  b.programs[0].report.jump_time_s = 1;
  EXPECT_NE(a.Print(), b.Print());
}

}  // namespace
}  // namespace slicefarm::laser_task_test
