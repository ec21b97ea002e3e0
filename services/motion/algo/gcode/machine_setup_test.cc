#include "services/motion/algo/gcode/machine_setup.h"

#include <gtest/gtest.h>

namespace slicefarm::motion {
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
  EXPECT_NE(Limits(GcodeFlavor::kMarlinLegacy).find("M204 S1500 R1500\n"), std::string::npos);
}

TEST(WriteMachineLimits, Klipper) {
  EXPECT_EQ(Limits(GcodeFlavor::kKlipper),
            "SET_VELOCITY_LIMIT VELOCITY=300 ACCEL=1500 SQUARE_CORNER_VELOCITY=5\n");
}

std::string Start(std::string_view start_gcode) {
  MotionOptions options;
  options.first_layer_temperature_c = 215;
  options.first_layer_bed_temperature_c = 60;
  GcodeText out;
  WriteStart(options, start_gcode, out);
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

TEST(Commands, AreWholeWordsAtTheStartOfALine) {
  EXPECT_TRUE(Commands("G28\n  M104 S0", {"M104", "M109"}));
  EXPECT_TRUE(Commands("M109", {"M104", "M109"}));
  EXPECT_TRUE(Commands("M104;", {"M104"}));
  EXPECT_FALSE(Commands("M1045 S0", {"M104"}));
  EXPECT_FALSE(Commands("; M104 S0", {"M104"}));
  EXPECT_FALSE(Commands("", {"M104"}));
}

}  // namespace
}  // namespace slicefarm::motion
