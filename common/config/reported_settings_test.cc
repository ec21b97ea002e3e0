#include "common/config/reported_settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/config/projects/ini.h"
#include "common/config/resolve.h"
#include "processes/fdm/model/fdm_settings.h"

namespace slicefarm::config::reported_settings_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::Pair;

ResolvedSettings ResolveOrDie(std::string_view ini) {
  const auto given = ReadIni(ini);
  EXPECT_TRUE(given.ok()) << given.status();
  auto resolved = Resolve(*given, Process::kFdm);
  EXPECT_TRUE(resolved.ok()) << resolved.status();
  return resolved.ok() ? *std::move(resolved) : ResolvedSettings{};
}

struct ReportCase {
  std::string name;
  std::string key;
  std::string value;
  std::string want;  // the line, or nothing
};

class ReportTest : public testing::TestWithParam<ReportCase> {};

TEST_P(ReportTest, Tells) {
  const ReportCase& c = GetParam();
  ReportedSettings reported;
  Report(c.key, c.value, reported);
  if (c.want.empty()) {
    EXPECT_THAT(reported, IsEmpty());
  } else {
    EXPECT_THAT(reported, ElementsAre(Pair(c.key, c.want)));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Keys, ReportTest,
    testing::Values(ReportCase{"NotSupportedYet", "wipe_tower", "1", "1"},
                    ReportCase{"OfTheProfile", "printer_notes", "MK3\\nS", "MK3\\nS"},
                    ReportCase{"Unknown", "new_in_3_0", "x", "x"},
                    ReportCase{"OneLine", "notes", "a\nM112\r", "a M112"},
                    ReportCase{"Password", "printhost_apikey", "secret", ""},
                    ReportCase{"Address", "print_host", "10.0.0.7", ""},
                    ReportCase{"OtherPrinters", "compatible_printers_condition", "x", ""},
                    ReportCase{"NoName", "a-b.c", "1", ""}, ReportCase{"Digit", "1a", "1", ""}),
    [](const auto& info) { return info.param.name; });

TEST(ReportedSettings, StandInTheEffectiveText) {
  const ResolvedSettings resolved = ResolveOrDie(
      "print_settings_id = 0.20mm QUALITY\nfilament_notes = \"a\\nb\"\nspiral_vase = 0\n"
      "extrusion_width = 0.45\nmax_volumetric_speed = 0\nfilament_retract_lift = "
      "nil\nend_filament_gcode = \"M900\"\nstart_filament_gcode = \"M901\"\n"
      "printhost_password = secret\nperimeters = 2\n");
  const std::string& text = resolved.effective_text;
  for (const char* line :
       {"print_settings_id = 0.20mm QUALITY\n", "filament_notes = \"a\\nb\"\n", "spiral_vase = 0\n",
        "\nextrusion_width = 0.45\n", "perimeters = 2\n", "start_filament_gcode = M901\n"}) {
    EXPECT_THAT(text, HasSubstr(line));
  }
  for (const char* none :
       {"secret", "filament_retract_lift", "end_filament_gcode", "\nmax_volumetric_speed"}) {
    EXPECT_THAT(text, Not(HasSubstr(none)));
  }
}

TEST(ReportedSettings, ResolveToThemselves) {
  const ResolvedSettings first = ResolveOrDie(
      "print_settings_id = a; b\nextrusion_width = 150%\nmax_volumetric_speed = 8\n"
      "start_filament_gcode = \"M900\"\ntop_solid_min_thickness = 0.9\nunknown = \n"
      "layer_gcode = ;[print_settings_id] [unknown]\n");
  const ResolvedSettings second = ResolveOrDie(first.effective_text);
  EXPECT_EQ(second.effective_text, first.effective_text);
  EXPECT_EQ(second.settings, first.settings);
}

TEST(ReportedSettings, GoWithTheLayersThatNameThem) {
  const std::string given = "notes = n\nspiral_vase = 0\n";
  EXPECT_EQ(FdmOf(ResolveOrDie(given).settings).machine.motion.layer_settings, "");
  EXPECT_EQ(
      FdmOf(ResolveOrDie(given + "layer_gcode = {if spiral_vase}[layer_height]{endif}\n").settings)
          .machine.motion.layer_settings,
      "layer_height = 0.3\nspiral_vase = 0\n");
}

TEST(LinesNamedIn, TakesWordsIndicesAndAliases) {
  const std::string text =
      "bed_shape = 0x0,1x0,1x1\nlayer_height = 0.2\nnotes = height\nprint_settings_id = id\n"
      "temperature = 210\n";
  EXPECT_EQ(LinesNamedIn("", text), "");
  EXPECT_EQ(LinesNamedIn("[height] M104 Slayer", text), "");
  EXPECT_EQ(LinesNamedIn("[temperature_0]{layer_height*2}", text),
            "layer_height = 0.2\ntemperature = 210\n");
  EXPECT_EQ(LinesNamedIn("{print_bed_max[0]}[print_preset]", text),
            "bed_shape = 0x0,1x0,1x1\nprint_settings_id = id\n");
}

}  // namespace
}  // namespace slicefarm::config::reported_settings_test
