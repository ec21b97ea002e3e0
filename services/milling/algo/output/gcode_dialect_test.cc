#include "services/milling/algo/output/gcode_dialect.h"

#include <gtest/gtest.h>

namespace slicefarm::milling::gcode_dialect_test {
namespace {

TEST(GcodeDialect, StartsAsTheControllerWants) {
  const MachiningOptions machining{
      .spindle_rpm = 9000, .coolant = Coolant::kFlood, .tool_number = 3};
  EXPECT_EQ(DialectOf(MillDialect::kLinuxCnc)->Start(machining, 0.01, 15),
            "G21 G17 G90 G91.1 G94 G40 G49 G80\nG64 P0.010\nT3 M6\nG43 H3\nG0 Z15.000\n"
            "S9000 M3\nG4 P3\nM8\n");
  EXPECT_EQ(DialectOf(MillDialect::kGrbl)->Start(machining, 0.01, 15),
            "G21 G17 G90 G91.1 G94 G40 G49\nT3\nG0 Z15.000\nS9000 M3\nG4 P3\nM8\n");
}

/// Neither dialect leaves the spindle or the coolant on.
TEST(GcodeDialect, EndsWithAllOff) {
  for (const MillDialect dialect : {MillDialect::kLinuxCnc, MillDialect::kGrbl}) {
    const std::string end = DialectOf(dialect)->End();
    for (const char* word : {"M9\n", "M5\n", "M2\n"}) EXPECT_NE(end.find(word), end.npos);
  }
}

}  // namespace
}  // namespace slicefarm::milling::gcode_dialect_test
