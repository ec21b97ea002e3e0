#include "services/motion/algo/firmware/reprap.h"

#include <gtest/gtest.h>

namespace slicefarm::motion::reprap_test {
namespace {

TEST(RepRap, KnowsItsCommands) {
  for (const char* text : {"G1 X1", "G10 P0 S200", "M566 X600", "M572 D0 S.05", "M116", "T0"})
    EXPECT_TRUE(RepRap().Knows(ParseGcodeLine(text))) << text;
  for (const char* text : {"M900 K.1", "M862.3 P 1", "SET_VELOCITY_LIMIT ACCEL=1"})
    EXPECT_FALSE(RepRap().Knows(ParseGcodeLine(text))) << text;
}

TEST(RepRap, ReadsWhatItWrites) {
  MachineLimits written;
  written.max_acceleration_mm_s2 = {11, 12, 13, 14};
  written.max_feedrate_mm_s = {60, 120, 180, 240};
  written.max_jerk_mm_s = {60, 120, 180, 240};
  written.max_acceleration_extruding_mm_s2 = 31;
  written.max_acceleration_travel_mm_s2 = 33;
  GcodeText out;
  RepRap().WriteLimits(written, out);
  EXPECT_NE(out.text().find("M203 X3600"), std::string::npos) << "in mm/min";
  MachineLimits read;
  std::string_view text = out.text();
  while (!text.empty()) {
    RepRap().ApplyLimits(ParseGcodeLine(text.substr(0, text.find('\n'))), read);
    text.remove_prefix(text.find('\n') + 1);
  }
  for (size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(read.max_feedrate_mm_s[i], written.max_feedrate_mm_s[i], 1e-9);
  for (size_t i = 0; i < 4; ++i) EXPECT_NEAR(read.max_jerk_mm_s[i], written.max_jerk_mm_s[i], 1e-9);
  EXPECT_EQ(read.max_acceleration_mm_s2, written.max_acceleration_mm_s2);
  EXPECT_EQ(read.max_acceleration_travel_mm_s2, 33);
}

TEST(RepRap, ArcSegmentsByRadiusAndSpeed) {
  EXPECT_DOUBLE_EQ(RepRap().ArcSegmentMm(100, 1000), 1);
  EXPECT_DOUBLE_EQ(RepRap().ArcSegmentMm(1, 1000), 0.2);
  EXPECT_DOUBLE_EQ(RepRap().ArcSegmentMm(100, 50), 0.25);
}

}  // namespace
}  // namespace slicefarm::motion::reprap_test
