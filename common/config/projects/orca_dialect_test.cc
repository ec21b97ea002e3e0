#include "common/config/projects/orca_dialect.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "common/config/projects/orca_settings.h"

namespace slicefarm::config::orca_dialect_test {
namespace {

using testing::Contains;
using testing::StartsWith;

std::vector<std::string> Lines(const std::vector<Setting>& from) {
  std::vector<std::string> lines;
  for (const Setting& setting : FromOrca(from, nullptr))
    lines.push_back(setting.key + " = " + setting.value);
  return lines;
}

std::string ValueOf(const std::vector<Setting>& from, std::string_view key) {
  const std::vector<Setting> taken = FromOrca(from, nullptr);
  const auto found = std::ranges::find(taken, key, &Setting::key);
  return found == taken.end() ? "not set" : found->value;
}

const std::vector<Setting> kX1 = {{"printer_model", "Bambu Lab X1 Carbon"},
                                  {"gcode_flavor", "marlin"},
                                  {"machine_max_speed_x", R"(["500","200"])"},
                                  {"scan_first_layer", "1"},
                                  {"layer_change_gcode", "M73 L{layer_num+1}"}};

TEST(OrcaDialect, BambuMachinesChooseTheirs) {
  const std::vector<std::string> lines = Lines(kX1);
  for (const char* line : {"gcode_flavor = bambu", "gcode_label_objects = firmware",
                           "remaining_times = 1", "machine_limits_usage = emit_to_gcode"})
    EXPECT_THAT(lines, Contains(line));
  EXPECT_EQ(ValueOf(kX1, "layer_gcode"),
            "M73 L{layer_num+1}\\n{if layer_num==1}M976 S1 P1 ; scan model before printing 2nd "
            "layer\\nM400 P100\\n{endif}");
}

TEST(OrcaDialect, OtherMachinesKeepTheirFlavour) {
  std::vector<Setting> voron = kX1;
  voron[0].value = "Voron 2.4 350";
  EXPECT_EQ(ValueOf(voron, "gcode_flavor"), "marlin");
  EXPECT_EQ(ValueOf(voron, "gcode_label_objects"), "not set");
  EXPECT_EQ(ValueOf(voron, "remaining_times"), "not set");
  EXPECT_EQ(ValueOf(voron, "layer_gcode"), "M73 L{layer_num+1}");
  voron.push_back({"disable_m73", "0"});
  EXPECT_EQ(ValueOf(voron, "remaining_times"), "1");
  voron.back().value = "1";
  EXPECT_EQ(ValueOf(voron, "remaining_times"), "not set");
}

TEST(OrcaDialect, LimitsAreWrittenAsOrcaSlicerDoes) {
  struct Case {
    std::string flavor, emit, want;
  };
  for (const auto& [flavor, emit, want] :
       {Case{"marlin", "1", "emit_to_gcode"}, Case{"marlin2", "", "emit_to_gcode"},
        Case{"reprapfirmware", "1", "emit_to_gcode"}, Case{"marlin", "0", "time_estimate_only"},
        Case{"klipper", "1", "not set"}}) {
    std::vector<Setting> from = {{"gcode_flavor", flavor}, {"machine_max_speed_x", R"(["500"])"}};
    if (!emit.empty()) from.push_back({"emit_machine_limits_to_gcode", emit});
    EXPECT_EQ(ValueOf(from, "machine_limits_usage"), want) << flavor << " " << emit;
  }
}

TEST(OrcaDialect, AChamberIsHeatedWhereItIsControlled) {
  std::vector<Setting> from = {{"chamber_temperature", R"(["60"])"}};
  EXPECT_EQ(ValueOf(from, "activate_chamber_temp_control"), "0");
  from.push_back({"activate_chamber_temp_control", R"(["1"])"});
  EXPECT_EQ(ValueOf(from, "activate_chamber_temp_control"), "1");
  from.front().value = R"(["0"])";
  EXPECT_EQ(ValueOf(from, "activate_chamber_temp_control"), "not set");
}

TEST(OrcaDialect, GcodeNamesWhatItsProgramWorksOut) {
  const auto code = [](const std::string& gcode, std::vector<Setting> more) {
    more.push_back({"machine_start_gcode", gcode});
    return ValueOf(more, "start_gcode");
  };
  constexpr char kExhaust[] = "M106 P3 S{during_print_exhaust_fan_speed_num[current_extruder]}";
  EXPECT_EQ(code(kExhaust, {{"during_print_exhaust_fan_speed", R"(["70"])"}}), "M106 P3 S{178}");
  EXPECT_EQ(code(kExhaust, {}), "M106 P3 S{153}") << "60 % is the standard";
  EXPECT_EQ(code("{if support_air_filtration}", {}), "{if 1}");
  EXPECT_EQ(code("{if support_air_filtration}", {{"support_air_filtration", "0"}}), "{if 0}");
  EXPECT_THAT(
      code("{if !in_head_wrap_detect_zone}",
           {{"head_wrap_detect_zone", R"(["226x224","256x224","256x256","226x256"])"}}),
      StartsWith("{if !(first_layer_print_max[0] > 226 and first_layer_print_min[0] < 256 and "));
  EXPECT_EQ(code("{if !in_head_wrap_detect_zone}", {{"head_wrap_detect_zone", "[]"}}),
            "{if !false}");
}

TEST(OrcaDialect, ReadsTheTimeLapseAndExcludedAreas) {
  const std::vector<Setting> from = {{"time_lapse_gcode", "M971 S11"},
                                     {"bed_exclude_area", R"(["0x0","18x0","18x28","0x28"])"},
                                     {"extruder_offset", R"(["0x2"])"},
                                     {"wall_sequence", "inner-outer-inner wall"},
                                     {"travel_speed", "500"},
                                     {"initial_layer_travel_speed", "50%"},
                                     {"retract_lift_enforce", R"(["Top and Bottom"])"},
                                     {"filament_retract_lift_enforce", R"(["nil"])"}};
  EXPECT_EQ(ValueOf(from, "time_lapse_gcode"), "M971 S11");
  EXPECT_EQ(ValueOf(from, "bed_exclude_area"), "0x0,18x0,18x28,0x28");
  EXPECT_EQ(ValueOf(from, "extruder_offset"), "0x2");
  EXPECT_EQ(ValueOf(from, "inner_outer_inner"), "1");
  EXPECT_EQ(ValueOf(from, "first_layer_travel_speed"), "250");
  EXPECT_EQ(ValueOf(from, "retract_lift_enforce"), "top_and_bottom");
  OrcaUnused unused;
  FromOrca(from, &unused);
  EXPECT_THAT(unused.of_print, testing::IsEmpty());
  EXPECT_THAT(unused.others, testing::IsEmpty());
}

}  // namespace
}  // namespace slicefarm::config::orca_dialect_test
