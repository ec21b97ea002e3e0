#include "services/motion/algo/firmware/marlin.h"

#include <gtest/gtest.h>

namespace slicefarm::motion::marlin_test {
namespace {

KinematicMove Towards(double x, double e) { return {10, {x, 0, 0, e}, 50, 0}; }

TEST(Marlin, KnowsItsCommands) {
  for (const char* text :
       {"G1 X1", "G29", "M205 X1", "M486 S1", "M862.3 P \"MK3S\"", "T0", "M572 S.1"})
    EXPECT_TRUE(Marlin2().Knows(ParseGcodeLine(text))) << text;
  for (const char* text : {"SET_VELOCITY_LIMIT ACCEL=1", "M566 X1", "G123456", "X1"})
    EXPECT_FALSE(Marlin2().Knows(ParseGcodeLine(text))) << text;
}

TEST(Marlin, AccelerationsByKindOfMove) {
  MachineLimits limits;
  limits.max_acceleration_extruding_mm_s2 = 1;
  limits.max_acceleration_travel_mm_s2 = 2;
  limits.max_acceleration_retracting_mm_s2 = 3;
  EXPECT_EQ(Marlin2().AccelerationFor(Towards(1, 0.1), limits), 1);
  EXPECT_EQ(Marlin2().AccelerationFor(Towards(1, 0), limits), 2);
  EXPECT_EQ(Marlin2().AccelerationFor(Towards(0, -1), limits), 3);
  EXPECT_EQ(MarlinLegacy().AccelerationFor(Towards(1, 0), limits), 1);
}

TEST(Marlin, ReadsWhatItWrites) {
  MachineLimits written;
  written.max_acceleration_mm_s2 = {11, 12, 13, 14};
  written.max_feedrate_mm_s = {21, 22, 23, 24};
  written.max_jerk_mm_s = {1, 2, 3, 4};
  written.max_acceleration_extruding_mm_s2 = 31;
  written.max_acceleration_retracting_mm_s2 = 32;
  written.max_acceleration_travel_mm_s2 = 33;
  GcodeText out;
  Marlin2().WriteLimits(written, out);
  MachineLimits read;
  std::string_view text = out.text();
  while (!text.empty()) {
    Marlin2().ApplyLimits(ParseGcodeLine(text.substr(0, text.find('\n'))), read);
    text.remove_prefix(text.find('\n') + 1);
  }
  EXPECT_EQ(read, written);
}

TEST(Marlin, TravelApartOnlyInMarlin2) {
  GcodeText out;
  Marlin2().WriteAcceleration(500, 1000, out);
  Marlin2().WriteAcceleration(0, 1000, out);
  Marlin2().WriteAcceleration(0.25, 0, out);  // not 0, which would stop some machines
  MarlinLegacy().WriteAcceleration(500, 0, out);
  EXPECT_EQ(out.text(), "M204 P500 T1000\nM204 T1000\nM204 P0.25\nM204 S500\n");
}

}  // namespace
}  // namespace slicefarm::motion::marlin_test
