#include "services/slicing/algo/mesh_io/threemf/settings/height_codes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "common/base/error.h"

namespace slicefarm::slicing::threemf::height_codes_test {
namespace {

using testing::ElementsAre;
using testing::Pair;

TEST(ReadHeightCodes, OfPrusaSlicer) {
  const auto codes = ReadHeightCodes(
      R"(<?xml version="1.0" encoding="utf-8"?><custom_gcodes_per_print_z>)"
      R"(<code print_z="0.6" type="0" extruder="1" color="#FF0000" extra="" gcode="M600"/>)"
      R"(<code print_z="1.2" type="1" extruder="1" color="" extra="Insert &lt;nut&gt;" gcode="M601"/>)"
      R"(<code print_z="1.4" type="2" extruder="2" color="#00FF00" extra="" gcode="tool_change"/>)"
      R"(<code print_z="1.6" type="3" extruder="1" color="" extra="" gcode=""/>)"
      R"(<code print_z="1.8" type="4" extruder="1" color="" extra="M300&#10;M400" gcode="M300"/>)"
      R"(<mode value="SingleExtruder"/></custom_gcodes_per_print_z>)",
      "part");
  ASSERT_TRUE(codes.ok()) << codes.status();
  EXPECT_THAT(*codes,
              ElementsAre(Pair(
                  1, ElementsAre(HeightCode{600'000, HeightCodeKind::kColorChange, "#FF0000"},
                                 HeightCode{1'200'000, HeightCodeKind::kPause, "Insert <nut>"},
                                 HeightCode{1'600'000, HeightCodeKind::kTemplate, ""},
                                 HeightCode{1'800'000, HeightCodeKind::kCustom, "M300\nM400"}))));
}

TEST(ReadHeightCodes, OfBambuStudioByPlate) {
  const auto codes = ReadHeightCodes(
      R"(<custom_gcodes_per_layer><plate><plate_info id="1"/><mode value="SingleExtruder"/></plate>)"
      R"(<plate><plate_info id="3"/><layer top_z="2.4" type="1" extruder="1" color="" extra="" )"
      R"(gcode="M400 U1"/></plate></custom_gcodes_per_layer>)",
      "part");
  ASSERT_TRUE(codes.ok()) << codes.status();
  EXPECT_THAT(*codes,
              ElementsAre(Pair(3, ElementsAre(HeightCode{2'400'000, HeightCodeKind::kPause, ""}))));
}

TEST(ReadHeightCodes, OfPrusaSlicerBeforeTypes) {
  const auto codes = ReadHeightCodes(
      R"(<custom_gcodes_per_print_z><code print_z="1" gcode="M600" extruder="1" color="#1"/>)"
      R"(<code print_z="2" gcode="M601" extruder="1" color=""/>)"
      R"(<code print_z="3" gcode="tool_change" extruder="2" color=""/>)"
      R"(<code print_z="4" gcode="M117 x" extruder="1" color=""/></custom_gcodes_per_print_z>)",
      "part");
  ASSERT_TRUE(codes.ok()) << codes.status();
  EXPECT_THAT(codes->at(1), ElementsAre(HeightCode{1'000'000, HeightCodeKind::kColorChange, "#1"},
                                        HeightCode{2'000'000, HeightCodeKind::kPause, ""},
                                        HeightCode{4'000'000, HeightCodeKind::kCustom, "M117 x"}));
}

TEST(ReadHeightCodes, NothingHarmfulComesThrough) {
  const auto pause =
      ReadHeightCodes(R"(<a><code print_z="1" type="1" extra="a&#10;M112"/></a>)", "part");
  ASSERT_TRUE(pause.ok()) << pause.status();
  EXPECT_EQ(pause->at(1)[0].text, "a M112");
  for (const char* text :
       {R"(<a><code print_z="x" type="1"/></a>)", R"(<a><code type="1"/></a>)",
        R"(<a><code print_z="-1" type="1"/></a>)", R"(<a><code print_z="1e9" type="1"/></a>)",
        R"(<a><code print_z="1" type="x"/></a>)", R"(<a>)"})
    EXPECT_EQ(DetailOf(ReadHeightCodes(text, "part").status()).reason, Reason::kMeshMalformed)
        << text;
  std::string many = "<a>";
  for (int i = 0; i <= kMaxHeightCodes; ++i) many += R"(<code print_z="1" type="1"/>)";
  EXPECT_EQ(DetailOf(ReadHeightCodes(many + "</a>", "part").status()).reason,
            Reason::kMeshTooLarge);
}

}  // namespace
}  // namespace slicefarm::slicing::threemf::height_codes_test
