#include "services/motion/algo/program/heat_waits.h"

#include <gtest/gtest.h>

namespace slicefarm::motion::heat_waits_test {
namespace {

TEST(HeatWaits, TakesAsLongAsTheRateSays) {
  HeatWaits waits({.nozzle_c_s = 2, .bed_c_s = 0.5});
  EXPECT_EQ(waits.Read(ParseGcodeLine("M140 S60"), 0), 0) << "does not wait";
  EXPECT_EQ(waits.Read(ParseGcodeLine("M109 S215"), 10), 95);
  EXPECT_EQ(waits.Read(ParseGcodeLine("M190 S60"), 105), 0) << "was heated meanwhile";
  EXPECT_EQ(waits.Read(ParseGcodeLine("M109 R220"), 200), 2.5);
  EXPECT_EQ(waits.Read(ParseGcodeLine("M109 S200"), 300), 0) << "cools down at once";
  EXPECT_EQ(waits.Read(ParseGcodeLine("M109 S210"), 300), 5);
}

TEST(HeatWaits, HeatingGoesOnWhenTheTargetChanges) {
  HeatWaits waits({.nozzle_c_s = 1, .bed_c_s = 1});
  waits.Read(ParseGcodeLine("M104 S100"), 0);
  EXPECT_EQ(waits.Read(ParseGcodeLine("M109 S125"), 50), 50);
}

TEST(HeatWaits, WithoutARateNobodyKnows) {
  HeatWaits waits({.nozzle_c_s = 2, .bed_c_s = 0});
  EXPECT_EQ(waits.Read(ParseGcodeLine("M190 S60"), 0), std::nullopt);
  EXPECT_EQ(waits.Read(ParseGcodeLine("M191 S40"), 0), std::nullopt);
  EXPECT_EQ(waits.Read(ParseGcodeLine("M116"), 0), std::nullopt);
  EXPECT_EQ(waits.Read(ParseGcodeLine("G28"), 0), 0);
}

}  // namespace
}  // namespace slicefarm::motion::heat_waits_test
