#include "services/motion/algo/firmware/bambu.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace slicefarm::motion::bambu_test {
namespace {

TEST(Bambu, LabelsAreBitsOfAMask) {
  GcodeText out;
  Bambu().BeginCopy(Bambu().LabelOf("a", 0), 0, out);
  Bambu().EndCopy("0", 0, out);
  Bambu().BeginCopy("9", 9, out);
  Bambu().BeginCopy("64", 64, out);  // outside the 64-bit mask
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
  EXPECT_EQ(out.text(), "M73 P12 R34\nM204 S800\nM900 K0.02\n");
}

TEST(Bambu, HeadTellsWhatThePrinterShows) {
  GcodeText out;
  Bambu().WriteHead({.moves_s = 339,
                     .total_s = 664,
                     .layers = 28,
                     .filament_mm = 2227.86,
                     .volume_mm3 = 5358.63,
                     .mass_g = 6.75,
                     .height_mm = 5.6,
                     .density_g_cm3 = 1.26,
                     .diameter_mm = 1.75,
                     .first_layer = {}},
                    out);
  EXPECT_THAT(out.text(), testing::StartsWith("; HEADER_BLOCK_START\n; BambuStudio 02"));
  EXPECT_THAT(out.text(), testing::HasSubstr("; model printing time: 5m 39s; total estimated time: "
                                             "11m 4s\n; total layer number: 28\n"));
  EXPECT_THAT(out.text(), testing::HasSubstr("; total filament length [mm] : 2227.86\n"
                                             "; total filament volume [cm^3] : 5358.63\n"
                                             "; total filament weight [g] : 6.75\n"
                                             "; filament_density: 1.26\n"
                                             "; filament_diameter: 1.75\n"
                                             "; max_z_height: 5.6\n; filament: 1\n"
                                             "; HEADER_BLOCK_END\n"));
}

TEST(Bambu, TellsThePrinterWhereLayersBeginAndEnd) {
  GcodeText out;
  Bambu().WriteLayersBegin(out);
  Bambu().WriteSecondLayer(out);
  Bambu().WriteLayersEnd(out);
  EXPECT_EQ(out.text(),
            "M981 S1 P20000 ; open spaghetti detector\n"
            "; open powerlost recovery\nM1003 S1\n"
            "; close powerlost recovery\nM1003 S0\n"
            "M981 S0 P20000 ; close spaghetti detector\n");
}

TEST(Bambu, LimitsAreThoseOfBambuStudio) {
  MachineLimits limits;
  limits.max_acceleration_mm_s2 = {20'000, 20'000, 500, 5'000};
  limits.max_feedrate_mm_s = {500, 500, 20, 30};
  limits.max_jerk_mm_s = {9, 9, 3, 2.5};
  limits.max_acceleration_extruding_mm_s2 = 20'000;
  limits.max_acceleration_retracting_mm_s2 = 5'000;
  limits.max_acceleration_travel_mm_s2 = 9'000;
  GcodeText out;
  Bambu().WriteLimits(limits, out);
  EXPECT_EQ(out.text(),
            "M201 X20000 Y20000 Z500 E5000\nM203 X500 Y500 Z20 E30\n"
            "M204 P20000 R5000 T20000\nM205 X9 Y9 Z3 E2.5\n");
}

// Printing and travel share one acceleration.
TEST(Bambu, OneAccelerationForAllWays) {
  MachineLimits limits;
  Bambu().ApplyLimits(ParseGcodeLine("M204 S700"), limits);
  EXPECT_EQ(Bambu().AccelerationFor({1, {1, 0, 0, 0}}, limits), 700);
  EXPECT_EQ(Bambu().AccelerationFor({1, {1, 0, 0, 0.1}}, limits), 700);
  for (const char* text : {"M620 S0A", "M1002 gcode_claim_action : 0", "M624 AQAAAAAAAAA=", "M625",
                           "G380 S2 Z30 F300"})
    EXPECT_TRUE(Bambu().Knows(ParseGcodeLine(text))) << text;
}

}  // namespace
}  // namespace slicefarm::motion::bambu_test
