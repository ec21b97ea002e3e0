#include "processes/fdm/settings/table/needs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/config/resolve.h"

namespace slicefarm::config::fdm::needs_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> Notes(const std::vector<std::pair<std::string, std::string>>& given,
                               Source source = Source::kRequest) {
  std::vector<Setting> settings;
  for (const auto& [key, value] : given) settings.push_back({key, value, source});
  const auto resolved = Resolve(settings, Process::kFdm);
  EXPECT_TRUE(resolved.ok()) << resolved.status();
  return resolved.ok() ? TextsOf(resolved->no_effect) : std::vector<std::string>{};
}

struct NeedCase {
  std::string name;
  std::pair<std::string, std::string> setting;
  std::pair<std::string, std::string> off;  // other settings with which it has no effect
  std::pair<std::string, std::string> on;
  std::string want;
};

class NeedTest : public testing::TestWithParam<NeedCase> {};

TEST_P(NeedTest, IsReportedWhileUnmet) {
  const NeedCase& c = GetParam();
  EXPECT_THAT(Notes({c.setting, c.off}),
              ElementsAre(c.setting.first + " = " + c.setting.second + ": needs " + c.want));
  EXPECT_THAT(Notes({c.setting, c.on}), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(
    Needs, NeedTest,
    testing::Values(
        NeedCase{"Lift",
                 {"retract_lift", "0.4"},
                 {"retract_length", "0"},
                 {"retract_length", "1"},
                 "retract_length above 0"},
        NeedCase{"FilamentsLift",
                 {"filament_retract_lift", "0.4"},
                 {"filament_retract_length", "0"},
                 {"filament_retract_length", "1"},
                 "retract_length above 0"},
        NeedCase{"Acceleration",
                 {"perimeter_acceleration", "800"},
                 {"default_acceleration", "0"},
                 {"default_acceleration", "1000"},
                 "default_acceleration above 0"},
        NeedCase{"CombinedHeight",
                 {"automatic_infill_combination_max_layer_height", "0.3"},
                 {"automatic_infill_combination", "0"},
                 {"automatic_infill_combination", "1"},
                 "automatic_infill_combination = 1"},
        NeedCase{"Corner",
                 {"square_corner_velocity", "8"},
                 {"gcode_flavor", "marlin2"},
                 {"gcode_flavor", "klipper"},
                 "gcode_flavor = klipper"},
        NeedCase{"Jerk",
                 {"machine_max_jerk_z", "8"},
                 {"gcode_flavor", "klipper"},
                 {"gcode_flavor", "marlin"},
                 "a gcode_flavor of Marlin"},
        NeedCase{"JerkByFeature",
                 {"external_perimeter_jerk", "8"},
                 {"default_jerk", "0"},
                 {"default_jerk", "9"},
                 "default_jerk above 0"},
        NeedCase{"Density",
                 {"fill_density", "30%"},
                 {"density_field", R"({"kind":"constant","density":0.2})"},
                 {"density_field", ""},
                 "no density_field, which replaces it"},
        NeedCase{"Pattern",
                 {"fill_pattern", "gyroid"},
                 {"stress_field", R"({"kind":"constant","stress":[1,0,0]})"},
                 {"stress_field", ""},
                 "no stress_field, which replaces it"},
        NeedCase{"AdaptiveBesideAProfile",
                 {"adaptive_layer_height", "1"},
                 {"layer_height_profile", "0;0.2;10;0.2"},
                 {"layer_height_profile", ""},
                 "no layer_height_profile, which replaces it"},
        NeedCase{"Clearance",
                 {"extruder_clearance_radius", "35"},
                 {"complete_objects", "0"},
                 {"complete_objects", "1"},
                 "complete_objects = 1"},
        NeedCase{
            "Skirt", {"min_skirt_length", "4"}, {"skirts", "0"}, {"skirts", "1"}, "skirts above 0"},
        NeedCase{"Brim",
                 {"brim_width", "4"},
                 {"brim_type", "no_brim"},
                 {"brim_type", "outer_only"},
                 "a brim_type other than no_brim, and no raft"},
        NeedCase{"BrimOfARaft",
                 {"brim_width", "4"},
                 {"raft_layers", "2"},
                 {"raft_layers", "0"},
                 "a brim_type other than no_brim, and no raft"},
        NeedCase{"Raft",
                 {"raft_expansion", "4"},
                 {"raft_layers", "0"},
                 {"raft_layers", "2"},
                 "raft_layers above 0"},
        NeedCase{"Fan", {"max_fan_speed", "80"}, {"cooling", "0"}, {"cooling", "1"}, "cooling = 1"},
        NeedCase{"LeastFan",
                 {"min_fan_speed", "80"},
                 {"cooling", "0"},
                 {"fan_always_on", "1"},
                 "cooling = 1 or fan_always_on = 1"}),
    [](const auto& info) { return info.param.name; });

TEST(UnmetNeeds, BridgesHaveTheirFanWithoutCooling) {
  EXPECT_THAT(Notes({{"bridge_fan_speed", "80"}, {"cooling", "0"}}), IsEmpty());
}

// A profile lists all settings. A request lists only intended settings, even if a value is the
// default.
TEST(UnmetNeeds, AProfilesStandardsAreNoWish) {
  EXPECT_THAT(Notes({{"square_corner_velocity", "5"}}, Source::kProfile), IsEmpty());
  EXPECT_THAT(Notes({{"square_corner_velocity", "8"}}, Source::kProfile),
              ElementsAre(HasSubstr("square_corner_velocity = 8")));
  EXPECT_THAT(Notes({{"square_corner_velocity", "5"}}), ElementsAre(HasSubstr("klipper")));
}

TEST(UnmetNeeds, CombiningByHeightTakesThePlaceOfANumberOfLayers) {
  EXPECT_THAT(Notes({{"layer_height", "0.1"},
                     {"infill_every_layers", "2"},
                     {"automatic_infill_combination", "1"}}),
              ElementsAre("infill_every_layers = 2: needs automatic_infill_combination = 0"));
  EXPECT_THAT(Notes({{"layer_height", "0.1"}, {"infill_every_layers", "2"}}), IsEmpty());
}

}  // namespace
}  // namespace slicefarm::config::fdm::needs_test
