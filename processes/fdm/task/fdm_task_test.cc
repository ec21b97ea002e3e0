#include "processes/fdm/task/fdm_task.h"

#include <gtest/gtest.h>

#include "processes/fdm/task/fdm_shared.h"

namespace slicefarm::fdm_task_test {
namespace {

TEST(FdmTask, WeighsItsLayers) {
  FdmTask task;
  task.range = {3, 5};
  const Task any = task;
  EXPECT_EQ(any.process(), Process::kFdm);
  EXPECT_EQ(any.weight(), 2);
  EXPECT_EQ(any.label().text, "layers 3 to 4");
}

TEST(FdmResult, HasTheSamePrintIfItsProgramsAreTheSame) {
  FdmResult a;
  a.programs.resize(2);
  FdmResult b = a;
  b.times[Stage::kInfill] = 1;
  EXPECT_EQ(a.Print(), b.Print());
  b.programs[0].gcode = "G1";
  EXPECT_NE(a.Print(), b.Print());
  EXPECT_EQ(b.ProgramBytes(), 2);
  a.programs[1].gcode = "G1";
  EXPECT_NE(a.Print(), b.Print()) << "of another layer";
}

}  // namespace
}  // namespace slicefarm::fdm_task_test
