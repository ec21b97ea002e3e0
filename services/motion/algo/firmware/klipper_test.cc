#include "services/motion/algo/firmware/klipper.h"

#include <gtest/gtest.h>

#include <array>

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
  MachineLimits written;
  written.max_feedrate_mm_s = {111, 111, 20, 120};
  written.max_acceleration_extruding_mm_s2 = 2222;
  written.square_corner_velocity_mm_s = 6;
  GcodeText out;
  Klipper().WriteLimits(written, out);
  MachineLimits read;
  Klipper().ApplyLimits(ParseGcodeLine(out.text()), read);
  EXPECT_EQ(read, written);
}

TEST(Klipper, RefusesThickBeads) {
  EXPECT_FALSE(Klipper().RefusesSection(0.64, 0.4));
  EXPECT_TRUE(Klipper().RefusesSection(0.65, 0.4));
}

TEST(Klipper, LabelsAreOneWord) { EXPECT_EQ(Klipper().LabelOf("my part.stl", 3), "my_part_stl-3"); }

TEST(Klipper, CornersAndCruises) {
  GcodeText out;
  Klipper().WriteJerk(std::array<double, 4>{9, 9, 0.4, 2.5}, out);
  Klipper().WriteAccelToDecel(3000, 1500, out);
  Klipper().WriteCruiseRatio(0.5, out);
  Klipper().WriteCruiseRatio(0, out);
  EXPECT_EQ(out.text(),
            "SET_VELOCITY_LIMIT SQUARE_CORNER_VELOCITY=9\n"
            "SET_VELOCITY_LIMIT ACCEL=3000 ACCEL_TO_DECEL=1500\n"
            "SET_VELOCITY_LIMIT MINIMUM_CRUISE_RATIO=0.5\n"
            "SET_VELOCITY_LIMIT MINIMUM_CRUISE_RATIO=0\n");
}

TEST(Klipper, ReadsBothFormsOfTheCruise) {
  MachineLimits limits;
  Klipper().ApplyLimits(ParseGcodeLine("SET_VELOCITY_LIMIT ACCEL=3000 ACCEL_TO_DECEL=900"), limits);
  EXPECT_NEAR(limits.minimum_cruise_ratio, 0.7, 1e-9);
  Klipper().ApplyLimits(ParseGcodeLine("SET_VELOCITY_LIMIT MINIMUM_CRUISE_RATIO=0.2"), limits);
  EXPECT_EQ(limits.minimum_cruise_ratio, 0.2);
}

}  // namespace
}  // namespace slicefarm::motion::klipper_test
