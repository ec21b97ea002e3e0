#include "services/motion/algo/firmware/klipper.h"

#include <gtest/gtest.h>

namespace slicefarm::motion::klipper_test {
namespace {

TEST(Klipper, KnowsItsCommands) {
  for (const char* text : {"G1 X1", "G11", "M204 S1", "M73 P0", "T1", "set_velocity_limit ACCEL=1"})
    EXPECT_TRUE(Klipper().Knows(ParseGcodeLine(text))) << text;
  for (const char* text : {"M201 X1", "M205 X1", "M486 S1", "M600", "START_PRINT", "G29"})
    EXPECT_FALSE(Klipper().Knows(ParseGcodeLine(text))) << text;
}

TEST(Klipper, LimitsAndAccelerations) {
  GcodeText out;
  Klipper().WriteLimits(MachineLimits{}, out);
  Klipper().WriteAcceleration(700.4, 0, out);
  EXPECT_EQ(out.text(),
            "SET_VELOCITY_LIMIT VELOCITY=300 ACCEL=1500 SQUARE_CORNER_VELOCITY=5\n"
            "M204 S700.4\n");
}

TEST(Klipper, ReadsWhatItWrites) {
  MachineLimits told;
  told.max_feedrate_mm_s = {111, 111, 20, 120};
  told.max_acceleration_extruding_mm_s2 = 2222;
  told.square_corner_velocity_mm_s = 6;
  GcodeText out;
  Klipper().WriteLimits(told, out);
  MachineLimits read;
  Klipper().ApplyLimits(ParseGcodeLine(out.text()), read);
  EXPECT_EQ(read, told);
}

TEST(Klipper, RefusesThickBeads) {
  EXPECT_FALSE(Klipper().RefusesSection(0.64, 0.4));
  EXPECT_TRUE(Klipper().RefusesSection(0.65, 0.4));
}

TEST(Klipper, LabelsAreOneWord) { EXPECT_EQ(Klipper().LabelOf("my part.stl", 3), "my_part_stl-3"); }

}  // namespace
}  // namespace slicefarm::motion::klipper_test
