#include "services/motion/algo/firmware/grbl.h"

#include <gtest/gtest.h>

namespace slicefarm::motion::grbl_test {
namespace {

TEST(Grbl, KnowsLasersAndNoExtruders) {
  for (const char* text : {"G0 X1 S0", "G1 X1 F600 S500", "G94", "M3 S0", "M4 S100", "M5", "M2"})
    EXPECT_TRUE(Grbl().Knows(ParseGcodeLine(text))) << text;
  for (const char* text : {"G29", "M83", "M104 S200", "M204 P500", "M73 P1", "EXCLUDE_OBJECT"})
    EXPECT_FALSE(Grbl().Knows(ParseGcodeLine(text))) << text;
}

TEST(Grbl, PlansWithItsJunctionDeviation) {
  MachineLimits limits;
  limits.junction_deviation_mm = 0;
  EXPECT_NE(Grbl().MakePlanner(limits), nullptr);
  EXPECT_EQ(Grbl().AccelerationFor({}, limits), limits.max_acceleration_mm_s2[0]);
}

}  // namespace
}  // namespace slicefarm::motion::grbl_test
