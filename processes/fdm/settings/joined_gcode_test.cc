#include "processes/fdm/settings/joined_gcode.h"

#include <gtest/gtest.h>

#include <string>

#include "common/base/error.h"
#include "common/config/resolve.h"
#include "processes/fdm/model/fdm_settings.h"
#include "processes/fdm/settings/draft_of_test.h"

namespace slicefarm::config::fdm::joined_gcode_test {
namespace {

absl::Status Fault(const Pairs& given) {
  std::vector<Setting> settings;
  for (const auto& [key, value] : given) settings.push_back({key, value});
  return Resolve(settings, Process::kFdm).status();
}

struct Case {
  const char* name;
  Pairs given;
  const char* setting;
  const char* line;
};

TEST(JoinedGcode, ErrorsNameTheSettingThatTheLineIsWrittenIn) {
  const Case cases[] = {
      {"of the filament", {{"start_filament_gcode", "{nothing}"}}, "start_filament_gcode", "1"},
      {"its second line",
       {{"start_gcode", "G28\nG1 Z5"}, {"start_filament_gcode", "G92 E0\n{nothing}\n"}},
       "start_filament_gcode",
       "2"},
      {"before it",
       {{"start_gcode", "G28\n{nothing}"}, {"start_filament_gcode", "G92 E0"}},
       "start_gcode",
       "2"},
      {"after the layers", {{"end_filament_gcode", "G1\n{nothing}"}}, "end_filament_gcode", "2"},
      {"behind it",
       {{"end_filament_gcode", "G1\nG1"}, {"end_gcode", "M84\n{nothing}"}},
       "end_gcode",
       "2"},
      {"that does not parse", {{"start_filament_gcode", "{1 +}"}}, "start_filament_gcode", "1"},
      {"of the layer alone", {{"layer_gcode", "{nothing}"}}, "layer_gcode", "1"},
      {"of the time lapse, which comes first",
       {{"time_lapse_gcode", "M240\n{nothing}"}, {"layer_gcode", "G92 E0\n"}},
       "time_lapse_gcode",
       "2"},
      {"behind the time lapse",
       {{"time_lapse_gcode", "M240"}, {"layer_gcode", "G92 E0\n{nothing}"}},
       "layer_gcode",
       "2"},
      {"of the time lapse on a Bambu, which comes last",
       {{"gcode_flavor", "bambu"},
        {"time_lapse_gcode", "M400\n{nothing}"},
        {"layer_gcode", "M73 L1"}},
       "time_lapse_gcode",
       "2"},
      {"between features, by the machine",
       {{"change_extrusion_role_gcode", "M1\n{nothing}"},
        {"filament_change_extrusion_role_gcode", "M2\nM2"},
        {"process_change_extrusion_role_gcode", "M3"}},
       "change_extrusion_role_gcode",
       "2"},
      {"between features, by the filament",
       {{"change_extrusion_role_gcode", "M1"},
        {"filament_change_extrusion_role_gcode", "M2\n{nothing}"},
        {"process_change_extrusion_role_gcode", "M3"}},
       "filament_change_extrusion_role_gcode",
       "2"},
      {"between features, by the process",
       {{"change_extrusion_role_gcode", "M1"},
        {"filament_change_extrusion_role_gcode", "M2"},
        {"process_change_extrusion_role_gcode", "M3\n{nothing}"}},
       "process_change_extrusion_role_gcode",
       "2"},
      {"of neither", {{"before_layer_gcode", "{nothing}"}}, "before_layer_gcode", "1"}};
  for (const Case& c : cases) {
    const absl::Status status = Fault(c.given);
    ASSERT_FALSE(status.ok()) << c.name;
    ErrorDetail detail = DetailOf(status);
    EXPECT_EQ(detail.reason, Reason::kSettingMalformed) << c.name;
    EXPECT_EQ(detail.metadata["setting"], c.setting) << c.name;
    EXPECT_EQ(detail.metadata["line"], c.line) << c.name;
    const std::string begins = std::string(c.setting) + ", line " + c.line + ": ";
    EXPECT_EQ(std::string(status.message()).substr(0, begins.size()), begins) << c.name;
  }
}

std::string LayerCode(const Pairs& given) {
  std::vector<Setting> settings;
  for (const auto& [key, value] : given) settings.push_back({key, value});
  const auto resolved = Resolve(settings, Process::kFdm);
  return resolved.ok() ? FdmOf(resolved->settings).machine.motion.layer_gcode.str() : "refused";
}

TEST(JoinedGcode, TheTimeLapseStandsWhereTheProgramThatOwnsItPutsIt) {
  const Pairs both = {{"time_lapse_gcode", "M240"}, {"layer_gcode", "M117"}};
  EXPECT_EQ(LayerCode(both), "M240\nM117");
  Pairs bambu = both;
  bambu.push_back({"gcode_flavor", "bambu"});
  EXPECT_EQ(LayerCode(bambu), "M117\nM240");
  EXPECT_EQ(LayerCode({{"layer_gcode", "M117"}}), "M117");
}

TEST(JoinedGcode, TheCheckForClumpsIsLimitedToItsLayers) {
  const Pairs given = {{"enable_wrapping_detection", "1"},
                       {"wrapping_detection_layers", "7"},
                       {"wrapping_detection_gcode", "G39"},
                       {"wrapping_exclude_area", "150x180,200x180,200x200,150x200"},
                       {"layer_gcode", "M117"}};
  EXPECT_EQ(LayerCode(given), "{if layer_num > 0 && layer_num <= 7}G39\n{endif}\nM117");
  for (const char* off : {"enable_wrapping_detection", "wrapping_exclude_area"}) {
    Pairs without = given;
    std::erase_if(without, [&](const auto& each) { return each.first == off; });
    EXPECT_EQ(LayerCode(without), "M117") << off;
  }
  Pairs wrong = given;
  wrong.push_back({"wrapping_detection_gcode", "G39\n{nothing}"});
  EXPECT_EQ(DetailOf(Fault(wrong)).metadata["setting"], "wrapping_detection_gcode");
  EXPECT_EQ(DetailOf(Fault(wrong)).metadata["line"], "2");
}

}  // namespace
}  // namespace slicefarm::config::fdm::joined_gcode_test
