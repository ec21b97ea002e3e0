#include "services/motion/algo/program/program_time.h"

#include <gtest/gtest.h>

#include "common/kinematics/trapezoid.h"
#include "services/motion/algo/firmware/klipper.h"
#include "services/motion/algo/firmware/marlin.h"
#include "services/motion/algo/firmware/reprap.h"

namespace slicefarm::motion::program_time_test {
namespace {

MachineSetup Machine() {
  MachineSetup setup;
  setup.limits.max_acceleration_extruding_mm_s2 = 3000;
  setup.limits.max_acceleration_travel_mm_s2 = 3000;
  return setup;
}

TEST(TimeOfProgram, ClosedForms) {
  const char kLine[] = "G1 X100 F6000\n";
  EXPECT_NEAR(TimeOfProgram(kLine, Klipper(), Machine()).TotalS(), 1.033333333, 1e-9);
  EXPECT_NEAR(TimeOfProgram(kLine, RepRap(), Machine()).TotalS(), 1.033333333, 1e-9);
  const char kCorner[] = "G1 X100 F6000\nG1 Y100\n";
  EXPECT_NEAR(TimeOfProgram(kCorner, Klipper(), Machine()).TotalS(), 2 * 1.031708333, 1e-8);
}

TEST(TimeOfProgram, StopsCostWhatAStopCosts) {
  const double twice = 2 * RestToRest(50, 100, 3000);
  for (const char* stop : {"G4 P0", "M400", "T0", "M109 S200"}) {
    const std::string gcode = std::string("G1 X50 F6000\n") + stop + "\nG1 X100\n";
    EXPECT_NEAR(TimeOfProgram(gcode, Klipper(), Machine()).TotalS(), twice, 1e-9) << stop;
  }
  const ProgramTime time = TimeOfProgram("G28\nM190 S60\nT0\nG4 P500\n", Klipper(), Machine());
  EXPECT_EQ(time.homings, 1);
  EXPECT_EQ(time.heat_waits, 1);
  EXPECT_EQ(time.tool_changes, 1);
  EXPECT_EQ(time.TotalS(), 0.5);
}

TEST(TimeOfProgram, ByFeatureAndLayer) {
  const ProgramTime time = TimeOfProgram(
      "G1 X5 F6000\n;LAYER_CHANGE\nM83\n;TYPE:Perimeter\nG1 X50 E2\nG1 E-.8 F2100\n"
      ";LAYER_CHANGE\nG1 Z.4\nG1 E.8\n;TYPE:Top solid infill\nG1 X0 E2 F6000\n",
      Klipper(), Machine());
  ASSERT_EQ(time.layer_s.size(), 2);
  ASSERT_EQ(time.feature_s.size(), 2);
  EXPECT_GT(time.before_s, 0);
  double features = time.travel_s + time.retract_s;
  for (const auto& [name, seconds] : time.feature_s) features += seconds;
  EXPECT_NEAR(features, time.move_s, 1e-9);
  EXPECT_NEAR(time.before_s + time.layer_s[0] + time.layer_s[1], time.TotalS(), 1e-9);
  EXPECT_NEAR(time.feature_s.at("Top solid infill"), RestToRest(50, 100, 3000), 1e-9);
}

TEST(TimeOfProgram, AccelerationsOfEachFirmware) {
  const char kTravel[] = "M204 P500 T2000\nG1 X100 F6000\n";
  EXPECT_NEAR(TimeOfProgram(kTravel, Klipper(), Machine()).TotalS(), RestToRest(100, 100, 500),
              1e-9);
  EXPECT_NEAR(TimeOfProgram(kTravel, RepRap(), Machine()).TotalS(), RestToRest(100, 100, 2000),
              1e-9);
  MachineSetup deviation = Machine();
  deviation.limits.junction_deviation_mm = 0.02;
  EXPECT_NEAR(TimeOfProgram(kTravel, Marlin2(), deviation).TotalS(), RestToRest(100, 100, 2000),
              1e-4);
}

TEST(TimeOfProgram, RetractionsRunWithTheExtrudersLimitsAndTheToolheadsCruiseRatio) {
  // Recorded from Klipper's host code: max_accel 3000, extruder 1500 mm/s2.
  EXPECT_NEAR(TimeOfProgram("M83\nG1 E.8 F2100\n", Klipper(), Machine()).retract_s, 0.046188022,
              2e-9);
}

TEST(TimeOfProgram, AnyBytes) {
  EXPECT_EQ(TimeOfProgram("\0\xff G1 X\nG1 Xx\r\n;;\nG1 X1e9", Marlin2(), Machine()).moves, 0);
}

TEST(TimeOfProgram, KnowsWhenEachLineEnds) {
  const ProgramTime time = TimeOfProgram(
      "M83\nG1 X100 F6000\n;TYPE:Perimeter\nG1 X200 E5\nG4 S1\nG1 X100\nM84\n", Klipper(), {});
  ASSERT_EQ(time.line_end_s.size(), 7);
  EXPECT_EQ(time.line_end_s[0], 0);
  EXPECT_GT(time.line_end_s[1], 1);
  EXPECT_EQ(time.line_end_s[2], time.line_end_s[1]);
  EXPECT_GT(time.line_end_s[3], time.line_end_s[1] + 0.9);
  EXPECT_NEAR(time.line_end_s[6], time.TotalS(), 1e-9);
  EXPECT_NEAR(time.line_end_s[5] - time.line_end_s[3], 1 + 1 + 100.0 / 1500, 0.01);
}

}  // namespace
}  // namespace slicefarm::motion::program_time_test
