#include "services/motion/algo/firmware/bambu.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace slicefarm::motion::bambu_test {
namespace {

TEST(Bambu, LabelsAreBitsOfAMask) {
  GcodeText out;
  Bambu().BeginCopy("a", 0, out);
  Bambu().EndCopy("a", 0, out);
  Bambu().BeginCopy("b", 9, out);
  Bambu().BeginCopy("c", 64, out);  // beyond the mask
  EXPECT_EQ(out.text(),
            "; start printing object, unique label id: 0\nM624 AQAAAAAAAAA=\n"
            "; stop printing object, unique label id: 0\nM625\n"
            "; start printing object, unique label id: 9\nM624 AAIAAAAAAAA=\n");
}

TEST(Bambu, HasBambuStudiosWords) {
  EXPECT_EQ(Bambu().comments().layer_change, "; CHANGE_LAYER");
  EXPECT_EQ(Bambu().WordsOf(Feature::kExternalPerimeter), "Outer wall");
  EXPECT_EQ(Bambu().WordsOf(Feature::kSupportInterface), "Support interface");
  GcodeText out;
  Bambu().WriteProgress(12, 34, 5, out);
  Bambu().WriteAcceleration(800, 0, out);
  Bambu().WritePressureAdvance(0.02, out);
  EXPECT_EQ(out.text(), "M73 P12 R34\nM73 L5\nM204 S800\nM900 K0.02\n");
}

TEST(Bambu, HeadTellsWhatThePrinterShows) {
  GcodeText out;
  Bambu().WriteHead({339, 664, 28, 0, 0, 0, 5.6, {}}, out);
  EXPECT_THAT(out.text(), testing::StartsWith("; HEADER_BLOCK_START\n; BambuStudio 02"));
  EXPECT_THAT(out.text(), testing::HasSubstr("; model printing time: 5m 39s; total estimated time: "
                                             "11m 4s\n; total layer number: 28\n"));
  EXPECT_THAT(out.text(), testing::HasSubstr("; max_z_height: 5.6\n; HEADER_BLOCK_END\n"));
}

// One acceleration for printing and travel.
TEST(Bambu, OneAccelerationForAllWays) {
  MachineLimits limits;
  Bambu().ApplyLimits(ParseGcodeLine("M204 S700"), limits);
  EXPECT_EQ(Bambu().AccelerationFor({1, {1, 0, 0, 0}}, limits), 700);
  EXPECT_EQ(Bambu().AccelerationFor({1, {1, 0, 0, 0.1}}, limits), 700);
  for (const char* text : {"M620 S0A", "M1002 gcode_claim_action : 0", "M624 AQAAAAAAAAA=", "M625"})
    EXPECT_TRUE(Bambu().Knows(ParseGcodeLine(text))) << text;
}

}  // namespace
}  // namespace slicefarm::motion::bambu_test
