#include "services/motion/algo/gcode/machine_setup.h"

#include <gtest/gtest.h>

#include "common/model/options/machine_limits.h"
#include "common/model/options/motion_options.h"

namespace slicefarm::motion::machine_setup_test {
namespace {

std::string Limits(GcodeFlavor flavor, double junction_deviation_mm = 0) {
  MotionOptions options;
  options.flavor = flavor;
  options.limits.emit_to_gcode = true;
  options.limits.junction_deviation_mm = junction_deviation_mm;
  GcodeText out;
  WriteMachineLimits(options, out);
  return out.Take();
}

TEST(WriteMachineLimits, OnlyIfAskedFor) {
  GcodeText out;
  WriteMachineLimits(MotionOptions{}, out);
  EXPECT_EQ(out.text(), "");
}

TEST(WriteMachineLimits, Marlin) {
  EXPECT_EQ(Limits(GcodeFlavor::kMarlin2),
            "M201 X3000 Y3000 Z500 E3000\nM203 X300 Y300 Z20 E120\nM204 P1500 R1500 T3000\n"
            "M205 X8 Y8 Z0.4 E2.5\n");
  EXPECT_NE(Limits(GcodeFlavor::kMarlin2, 0.02).find("M205 J0.02\n"), std::string::npos);
  EXPECT_NE(Limits(GcodeFlavor::kMarlinLegacy).find("M204 S1500 T1500\n"), std::string::npos);
  EXPECT_NE(Limits(GcodeFlavor::kMarlinLegacy).find("M205 S0 T0\n"), std::string::npos);
}

TEST(WriteMachineLimits, Klipper) {
  EXPECT_EQ(Limits(GcodeFlavor::kKlipper),
            "SET_VELOCITY_LIMIT VELOCITY=300 ACCEL=1500 SQUARE_CORNER_VELOCITY=5\n");
}

std::string Start(std::string_view machine, std::string_view filament = {}, int32_t tool = -1) {
  MotionOptions options;
  options.tool().first_layer_temperature_c = 215;
  options.tool().first_layer_bed_temperature_c = 60;
  GcodeText out;
  options.tool().number = tool;
  WriteStart(options, {machine, filament}, out);
  return out.Take();
}

TEST(WriteStart, HeatsUpAroundIt) {
  EXPECT_EQ(Start("G28"), "M190 S60\nM104 S215\nG28\nM109 S215\n");
}

TEST(WriteStart, LeavesTheStartGcodeItsWay) {
  EXPECT_EQ(Start("M104 S200\nG28\n"), "M190 S60\nM104 S200\nG28\n");
  EXPECT_EQ(Start("M140 S50\nG28\n"), "M104 S215\nM140 S50\nG28\nM109 S215\n");
  EXPECT_EQ(Start(""), "M190 S60\nM104 S215\nM109 S215\n");
}

// A filament's G-code that sets its temperature does not wait for it. Without heating before, the
// print would begin cold.
TEST(WriteStart, HeatsUpBeforeTheFilamentsCode) {
  EXPECT_EQ(Start("G28", "M104 S215\nG4 S2"),
            "M190 S60\nM104 S215\nG28\nM109 S215\nM104 S215\nG4 S2\n");
  EXPECT_EQ(Start("G28\n", "M140 S60\n"), "M190 S60\nM104 S215\nG28\nM109 S215\nM140 S60\n");
  EXPECT_EQ(Start("M109 S200\nM190 S50", "M900 K1"), "M109 S200\nM190 S50\nM900 K1\n");
  EXPECT_EQ(Start("M109 S200\nM190 S50", "M900 K1", 1), "M109 S200\nM190 S50\nT1\nM900 K1\n");
}

TEST(LimitsAfterStart, StartGcodeHoldsOverTheSettings) {
  MotionOptions options;
  options.start_gcode = "G28 ; M201 X9\nM201 X750 Y{oops}\nM203 X90 ; comment\nM204 P600\nG1 X1 X2";
  MachineLimits limits = LimitsAfterStart(options);
  EXPECT_EQ(limits.max_acceleration_mm_s2, options.limits.max_acceleration_mm_s2);
  EXPECT_EQ(limits.max_feedrate_mm_s[0], 90);
  EXPECT_EQ(limits.max_acceleration_extruding_mm_s2, 600);
  options.tool().start_filament_gcode = "M203 X80";
  EXPECT_EQ(LimitsAfterStart(options).max_feedrate_mm_s[0], 80);
  options.default_acceleration_mm_s2 = 1000;
  EXPECT_EQ(LimitsAfterStart(options).max_acceleration_extruding_mm_s2,
            options.limits.max_acceleration_extruding_mm_s2)
      << "the layers tell it by themselves";
  options.flavor = GcodeFlavor::kKlipper;
  options.start_gcode = "SET_VELOCITY_LIMIT SQUARE_CORNER_VELOCITY=8";
  EXPECT_EQ(LimitsAfterStart(options).square_corner_velocity_mm_s, 8);
}

TEST(WriteLayerLimits, OnlyThoseOfTheFirmware) {
  const auto text = [](const MotionOptions& options) {
    GcodeText out;
    WriteLayerLimits(options, out);
    return out.Take();
  };
  MotionOptions options;
  EXPECT_EQ(text(options), "");
  options.accel_to_decel = 0.3;
  options.jerk.junction_deviation_mm = 0.02;
  EXPECT_EQ(text(options), "") << "the machine has no junction deviation";
  options.limits.junction_deviation_mm = 0.013;
  EXPECT_EQ(text(options), "M205 J0.013\n");
  options.limits.junction_deviation_mm = 0.05;
  EXPECT_EQ(text(options), "M205 J0.02\n");
  EXPECT_EQ(LimitsAfterStart(options).junction_deviation_mm, 0.02);
  options.flavor = GcodeFlavor::kMarlinLegacy;
  EXPECT_EQ(text(options), "");
  options.flavor = GcodeFlavor::kKlipper;
  EXPECT_EQ(text(options), "SET_VELOCITY_LIMIT MINIMUM_CRUISE_RATIO=0.7\n");
  EXPECT_NEAR(LimitsAfterStart(options).minimum_cruise_ratio, 0.7, 1e-9);
}

}  // namespace
}  // namespace slicefarm::motion::machine_setup_test
