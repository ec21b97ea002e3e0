#include "services/motion/algo/firmware/prusa_buddy.h"

#include <gtest/gtest.h>

#include "common/model/options/motion_options.h"

namespace slicefarm::motion::prusa_buddy_test {
namespace {

PrintFacts Facts() {
  PrintFacts facts;
  facts.first_layer = {{FromMm(10.2), FromMm(20.9)}, {FromMm(40.1), FromMm(50)}};
  return facts;
}

std::string Checks(const MotionOptions& options, const PrintFacts& facts = Facts()) {
  GcodeText out;
  PrusaBuddy().WriteChecks(options, facts, out);
  return out.Take();
}

TEST(PrusaBuddy, ChecksNozzleModelAndArea) {
  MotionOptions options;
  options.printer_model = "MK4";
  EXPECT_EQ(Checks(options), "M862.1 P0.4\nM862.3 P \"MK4\"\nM555 X10 Y20 W31 H30\n");
  options.printer_model.clear();
  EXPECT_EQ(Checks(options, {}), "M862.1 P0.4\n");
}

TEST(PrusaBuddy, StartGcodeThatChecksKnowsBetter) {
  MotionOptions options;
  options.start_gcode = "M862.3 P \"XL\"\nM555 X0 Y0 W9 H9\nG28";
  EXPECT_EQ(Checks(options), "");
}

TEST(PrusaBuddy, ANameIsNoCommand) {
  MotionOptions options;
  options.printer_model = "MK4\"\nM112 ; \\";
  EXPECT_EQ(Checks(options, {}), "M862.1 P0.4\nM862.3 P \"MK4 M112  \"\n");
}

TEST(PrusaBuddy, HasMarlinsCommandsAndItsOwnPressureAdvance) {
  GcodeText out;
  PrusaBuddy().WritePressureAdvance(0.035, out);
  PrusaBuddy().WriteAcceleration(500, 1000, out);
  EXPECT_EQ(out.text(), "M572 S0.035\nM204 P500 T1000\n");
  for (const char* text : {"M862.3 P \"MK4\"", "M555 X0", "M572 S0.1", "M486 S1", "M73 P1 R2"})
    EXPECT_TRUE(PrusaBuddy().Knows(ParseGcodeLine(text))) << text;
}

}  // namespace
}  // namespace slicefarm::motion::prusa_buddy_test
