#include "services/motion/algo/program/gcode_machine.h"

#include <gtest/gtest.h>

#include "common/model/options/motion_options.h"
#include "services/motion/algo/firmware/klipper.h"
#include "services/motion/algo/firmware/marlin.h"
#include "services/motion/algo/firmware/reprap.h"

namespace slicefarm::motion::gcode_machine_test {
namespace {

/// Returns the end of the last move of a program.
std::array<double, 4> EndOf(const Firmware& firmware, std::vector<const char*> lines,
                            double* speed = nullptr) {
  GcodeMachine machine(firmware, {});
  for (const char* text : lines) {
    const GcodeAction action = machine.Read(ParseGcodeLine(text));
    if (speed != nullptr && !action.moves.empty()) *speed = action.moves.back().speed_mm_s;
  }
  return machine.position();
}

using Place = std::array<double, 4>;

TEST(GcodeMachine, AbsoluteAndRelative) {
  EXPECT_EQ(EndOf(Klipper(), {"G1 X10 Y5 Z1 E2", "G1 X12 E3"}), (Place{12, 5, 1, 3}));
  EXPECT_EQ(EndOf(Klipper(), {"G91", "G1 X10 E2", "G1 X12 E3"}), (Place{22, 0, 0, 5}));
  EXPECT_EQ(EndOf(Klipper(), {"M83", "G1 X10 E2", "G1 X12 E3"}), (Place{12, 0, 0, 5}));
}

TEST(GcodeMachine, WhatRelativeAxesMeanForFilament) {
  const std::vector<const char*> lines = {"M82", "G91", "G1 E2", "G1 E3"};
  EXPECT_EQ(EndOf(Klipper(), lines)[kE], 5);
  EXPECT_EQ(EndOf(Marlin2(), lines)[kE], 5);
  EXPECT_EQ(EndOf(RepRap(), lines)[kE], 3);
  const std::vector<const char*> back = {"M83", "G90", "G1 E2", "G1 E3"};
  EXPECT_EQ(EndOf(Klipper(), back)[kE], 5);
  EXPECT_EQ(EndOf(Marlin2(), back)[kE], 3) << "G90 is for all axes";
  EXPECT_EQ(EndOf(RepRap(), back)[kE], 5);
}

TEST(GcodeMachine, OriginsUnitsAndHoming) {
  EXPECT_EQ(EndOf(Klipper(), {"G1 X10 E4", "G92 X0 E0", "G1 X1 E1"}), (Place{11, 0, 0, 5}));
  EXPECT_EQ(EndOf(Klipper(), {"G20", "G1 X1"})[kX], 25.4);
  EXPECT_EQ(EndOf(Klipper(), {"G1 X9 Y9 Z9", "G28 X"}), (Place{0, 9, 9, 0}));
  EXPECT_EQ(EndOf(Klipper(), {"G1 X9 Y9 Z9", "G28"}), (Place{0, 0, 0, 0}));
}

TEST(GcodeMachine, Factors) {
  double speed = 0;
  EXPECT_EQ(EndOf(Klipper(), {"M220 S50", "M221 S200", "G1 X10 E1 F6000"}, &speed)[kE], 2);
  EXPECT_EQ(speed, 50);
  EXPECT_EQ(EndOf(Klipper(), {"G1 E4", "M221 S50", "G1 E6"})[kE], 5) << "what is in stays in";
}

TEST(GcodeMachine, FirmwareRetraction) {
  MachineSetup setup;
  setup.retraction = {.length_mm = 2, .speed_mm_s = 40, .restart_extra_mm = 0.1, .lift_mm = 0};
  GcodeMachine machine(Klipper(), setup);
  machine.Read(ParseGcodeLine("G1 X1 E5 F600"));
  const GcodeAction out = machine.Read(ParseGcodeLine("G10"));
  ASSERT_EQ(out.moves.size(), 1);
  EXPECT_EQ(out.moves[0].Filament(), -2);
  EXPECT_EQ(out.moves[0].speed_mm_s, 40);
  EXPECT_TRUE(machine.Read(ParseGcodeLine("G10")).moves.empty()) << "once";
  EXPECT_NEAR(machine.Read(ParseGcodeLine("G11")).moves[0].Filament(), 2.1, 1e-12);
  EXPECT_NEAR(machine.Read(ParseGcodeLine("G1 X2 E6")).moves[0].Filament(), 1, 1e-12);
  EXPECT_FALSE(IsFirmwareRetraction(ParseGcodeLine("G10 P0 S200")));
}

TEST(GcodeMachine, FilamentMayBeAVolume) {
  constexpr double kAreaMm2 = 2.405281875;  // section of filament of 1.75 mm
  const auto pushed = [](GcodeMachine& machine, const char* line) {
    return machine.Read(ParseGcodeLine(line)).moves[0].Filament();
  };
  GcodeMachine machine(Marlin2(), {});
  machine.Read(ParseGcodeLine("G1 X1 E4 F600"));
  machine.Read(ParseGcodeLine("M200 D1.75"));
  EXPECT_NEAR(pushed(machine, "G1 X2 E6"), 2 / kAreaMm2, 1e-6) << "places stay";
  machine.Read(ParseGcodeLine("M221 S50"));
  EXPECT_NEAR(pushed(machine, "G1 X3 E8"), 1 / kAreaMm2, 1e-6);
  machine.Read(ParseGcodeLine("M200 D0"));
  EXPECT_NEAR(pushed(machine, "G1 X4 E10"), 1, 1e-9);

  MotionOptions options;
  options.writing.volumetric_e = true;
  GcodeMachine by_settings(Marlin2(), SetupOf(options));
  EXPECT_NEAR(pushed(by_settings, "G1 X1 E4 F600"), 4 / kAreaMm2, 1e-6);
}

TEST(GcodeMachine, ArcsAreChordsWithTheirShareOfFilament) {
  GcodeMachine machine(Klipper(), {});
  machine.Read(ParseGcodeLine("G1 X10 F600"));
  const GcodeAction action = machine.Read(ParseGcodeLine("G3 X-10 Y0 I-10 J0 E3"));
  ASSERT_EQ(action.moves.size(), 31);
  EXPECT_TRUE(action.arc);
  for (const ProgramMove& move : action.moves) EXPECT_NEAR(move.Filament(), 3.0 / 31, 1e-12);
  EXPECT_EQ(machine.position(), (Place{-10, 0, 0, 3}));
}

TEST(GcodeMachine, ArcsHaveTheChordsThatTheMachineIsSetTo) {
  MachineSetup setup;
  setup.arc_segment_mm = 0.1;
  GcodeMachine machine(Klipper(), setup);
  machine.Read(ParseGcodeLine("G1 X10 F600"));
  EXPECT_EQ(machine.Read(ParseGcodeLine("G3 X-10 Y0 I-10 J0 E3")).moves.size(), 314);
}

TEST(GcodeMachine, LimitsByFirmware) {
  const auto limits = [](const Firmware& firmware, const char* line) {
    GcodeMachine machine(firmware, {});
    machine.Read(ParseGcodeLine(line));
    return machine.limits();
  };
  EXPECT_EQ(limits(Klipper(), "M204 S700").max_acceleration_extruding_mm_s2, 700);
  EXPECT_EQ(limits(Klipper(), "M204 P700 T600").max_acceleration_extruding_mm_s2, 600);
  EXPECT_EQ(limits(Klipper(), "M204 P700"), MachineLimits{});
  EXPECT_EQ(limits(Marlin2(), "M204 P700").max_acceleration_extruding_mm_s2, 700);
  EXPECT_EQ(limits(Marlin2(), "M205 J0.02").junction_deviation_mm, 0.02);
  EXPECT_EQ(limits(Marlin2(), "M203 X100").max_feedrate_mm_s[kX], 100);
  EXPECT_EQ(limits(RepRap(), "M203 X6000").max_feedrate_mm_s[kX], 100);
  EXPECT_EQ(limits(RepRap(), "M566 E300").max_jerk_mm_s[kE], 5);
  EXPECT_EQ(limits(Klipper(), "SET_VELOCITY_LIMIT SQUARE_CORNER_VELOCITY=0 VELOCITY=80")
                .square_corner_velocity_mm_s,
            0);
}

TEST(GcodeMachine, Stops) {
  GcodeMachine machine(Klipper(), {});
  EXPECT_EQ(machine.Read(ParseGcodeLine("G4 P1500")).dwell_s, 1.5);
  for (const char* text : {"G28", "M400", "M109 S200", "T1"})
    EXPECT_EQ(machine.Read(ParseGcodeLine(text)).kind, GcodeAction::Kind::kRest) << text;
}

}  // namespace
}  // namespace slicefarm::motion::gcode_machine_test
