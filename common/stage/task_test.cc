#include "common/stage/task.h"

#include <gtest/gtest.h>

#include "common/base/error.h"

namespace slicefarm::task_test {
namespace {

class Fdm : public FdmRunner {
 public:
  absl::StatusOr<FdmResult> Run(const StageCall&, const FdmTask& task) const override {
    FdmResult result;
    result.programs.resize(static_cast<size_t>(task.range.size()));
    return result;
  }
};

class Laser : public LaserRunner {
 public:
  absl::StatusOr<LaserResult> Run(const StageCall&, const LaserTask&) const override {
    return absl::UnavailableError("dark");
  }
};

FdmTask OfFdm(LayerRange range) {
  FdmTask task;
  task.range = range;
  return task;
}

TEST(Task, TellsItsProcessAndLayers) {
  const Task fdm = OfFdm({3, 5});
  EXPECT_EQ(ProcessOf(fdm), Process::kFdm);
  EXPECT_EQ(LayersOf(fdm), (LayerRange{3, 5}));
  EXPECT_EQ(ProcessOf(Task(LaserTask())), Process::kLaser);
}

TEST(Task, ResultsHaveTheSamePrintIfTheirProgramsAreTheSame) {
  FdmResult a;
  a.programs.resize(2);
  FdmResult b = a;
  b.times.infill_s = 1;
  EXPECT_EQ(PrintOf(a), PrintOf(b));
  b.programs[0].gcode = "G1";
  EXPECT_NE(PrintOf(a), PrintOf(b));
  a.programs[1].gcode = "G1";
  EXPECT_NE(PrintOf(a), PrintOf(b)) << "of another layer";
  LaserResult c;
  c.programs.resize(1);
  LaserResult d = c;
  EXPECT_EQ(PrintOf(c), PrintOf(d));
  d.programs[0].report.jump_time_s = 1;
  EXPECT_NE(PrintOf(c), PrintOf(d));
}

TEST(Task, TimesAddUp) {
  StageTimes times{1, 2, 3, 4, 5, 6, 7};
  times.Add({10, 20, 30, 40, 50, 60, 70});
  EXPECT_EQ(times.slicing_s, 11);
  EXPECT_EQ(times.motion_s, 66);
  EXPECT_EQ(times.exposure_s, 77);
}

TEST(ProcessRunners, GiveEachTaskToItsRunner) {
  const Fdm fdm;
  const Laser laser;
  const ProcessRunners both({&fdm, &laser});
  EXPECT_EQ(both.processes(), ProcessSet::All());
  const auto result = both.RunTask({}, OfFdm({0, 4}));
  ASSERT_TRUE(result.ok()) << result.status();
  EXPECT_EQ(std::get<FdmResult>(*result).programs.size(), 4u);
  EXPECT_EQ(both.RunTask({}, LaserTask()).status(), absl::UnavailableError("dark"));
}

TEST(ProcessRunners, WhatNobodyMakesIsAnError) {
  const Fdm fdm;
  const ProcessRunners one({&fdm});
  EXPECT_EQ(one.processes(), ProcessSet{Process::kFdm});
  EXPECT_EQ(DetailOf(one.RunTask({}, LaserTask()).status()).reason, Reason::kInternal);
}

}  // namespace
}  // namespace slicefarm::task_test
