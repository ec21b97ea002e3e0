#include "processes/laser/settings/laser_settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/base/error.h"
#include "common/config/projects/ini.h"
#include "common/config/resolve.h"
#include "common/config/setting_pairs_test.h"
#include "processes/laser/model/exposure_options.h"
#include "processes/laser/model/exposure_settings.h"

namespace slicefarm::config::laser::laser_settings_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

absl::StatusOr<ResolvedSettings> OfLaser(const Pairs& given, Source source = Source::kRequest) {
  std::vector<Setting> settings;
  for (const auto& [key, value] : given) settings.push_back({key, value, source});
  return Resolve(settings, Process::kLaser);
}

TEST(ResolveLaser, EverySettingReachesItsOption) {
  const auto resolved = OfLaser({{"scan_strategy", "rings"},
                                 {"hatch_distance", "0.11"},
                                 {"hatch_rotation", "90"},
                                 {"upskin_power", "150"},
                                 {"thin_wall_speed", "300"},
                                 {"downskin_layers", "3"},
                                 {"jump_speed", "7000"},
                                 {"output_format", "cli_binary"},
                                 {"layer_height", "0.03"}});
  ASSERT_TRUE(resolved.ok()) << resolved.status();
  EXPECT_EQ(resolved->settings.process(), Process::kLaser);
  const ExposureOptions& region = ExposureOf(resolved->settings).region;
  EXPECT_EQ(region.strategy, ScanStrategy::kRings);
  EXPECT_EQ(region.hatch_distance_nm, 110'000);
  EXPECT_EQ(region.layer_rotation_deg, 90);
  EXPECT_EQ(region.StyleOf(ExposureKind::kUpskin).power_w, 150);
  EXPECT_EQ(region.StyleOf(ExposureKind::kHatch).power_w, 200);
  EXPECT_EQ(region.StyleOf(ExposureKind::kThinWall).speed_mm_s, 300);
  EXPECT_EQ(region.downskin_layers, 3);
  EXPECT_EQ(region.jump.speed_mm_s, 7000);
  EXPECT_EQ(ExposureOf(resolved->settings).output.format, OutputFormat::kCliBinary);
  EXPECT_EQ(resolved->settings.object.layer_height_nm, 30'000);
  // Rings do not turn, there is no upskin, and a CLI file has no jumps.
  EXPECT_THAT(TextsOf(resolved->no_effect),
              ElementsAre(HasSubstr("hatch_rotation = 90: "), HasSubstr("jump_speed = 7000: "),
                          HasSubstr("upskin_power = 150: ")));
}

// The default values in the table equal the default values of the options.
TEST(ResolveLaser, StandardsAreTheDefaults) {
  const auto resolved = OfLaser({});
  ASSERT_TRUE(resolved.ok()) << resolved.status();
  EXPECT_EQ(ExposureOf(resolved->settings), ExposureRows());
}

TEST(ResolveLaser, ReadsItsOwnEffectiveText) {
  const auto first = OfLaser({{"scan_strategy", "islands"}, {"contour_focus", "-1.5"}});
  ASSERT_TRUE(first.ok()) << first.status();
  const auto lines = ReadIni(first->effective_text);
  ASSERT_TRUE(lines.ok()) << lines.status();
  const auto second = Resolve(*lines, Process::kLaser);
  ASSERT_TRUE(second.ok()) << second.status();
  EXPECT_EQ(second->settings, first->settings);
  EXPECT_EQ(second->effective_text, first->effective_text);
  EXPECT_THAT(TextsOf(second->no_effect), IsEmpty());
}

TEST(ResolveLaser, SettingsOfOtherProcessesAreRefused) {
  for (const char* key : {"perimeters", "fill_density", "temperature"}) {
    const ErrorDetail detail = DetailOf(OfLaser({{key, "1"}}).status());
    EXPECT_EQ(detail.reason, Reason::kSettingOfOtherProcess) << key;
    EXPECT_EQ(detail.metadata.at("setting"), key);
    EXPECT_EQ(detail.metadata.at("process"), "fdm");
  }
  const std::vector<Setting> laser = {{"hatch_distance", "0.1", Source::kRequest}};
  const ErrorDetail detail = DetailOf(Resolve(laser, Process::kFdm).status());
  EXPECT_EQ(detail.reason, Reason::kSettingOfOtherProcess);
  EXPECT_EQ(detail.metadata.at("process"), "laser");
}

TEST(ResolveLaser, ThoseOfAProfileAreTold) {
  const auto resolved = OfLaser({{"perimeters", "3"}}, Source::kProfile);
  ASSERT_TRUE(resolved.ok()) << resolved.status();
  EXPECT_THAT(TextsOf(resolved->no_effect),
              ElementsAre("perimeters = 3: a setting of process fdm"));
}

TEST(ResolveLaser, TellsWhatHasNoEffect) {
  const auto resolved =
      OfLaser({{"scan_strategy", "hatch"}, {"stripe_width", "4"}, {"output_layer", "2"}});
  ASSERT_TRUE(resolved.ok()) << resolved.status();
  EXPECT_THAT(TextsOf(resolved->no_effect),
              ElementsAre("output_layer = 2: needs output_format = dxf",
                          "stripe_width = 4: needs scan_strategy = stripes"));
}

TEST(ResolveLaser, TellsWhatTheFileCannotSay) {
  struct Case {
    Pairs given;
    std::vector<std::string> notes;
  };
  const Case kCases[] = {
      {{{"jump_delay", "100"}},
       {"jump_delay = 100: needs output_format = grbl or marlin, otherwise only the report uses "
        "it"}},
      {{{"output_format", "grbl"}, {"hatch_frequency", "20"}},
       {"hatch_frequency = 20: needs output_format = cli or cli_binary, otherwise only the report "
        "uses "
        "it"}},
      {{{"output_format", "grbl"}, {"jump_speed", "3000"}},
       {"jump_speed = 3000: needs output_format = marlin, otherwise only the report uses it"}},
      {{{"output_format", "svg"}, {"hatch_focus", "1"}},
       {"hatch_focus = 1: needs output_format = cli, cli_binary, grbl or marlin, otherwise only "
        "the "
        "report uses it"}},
      {{{"contours", "0"}, {"contour_power", "100"}},
       {"contour_power = 100: needs contours above 0"}},
      {{{"upskin_power", "100"}}, {"upskin_power = 100: needs upskin_layers above 0"}},
      {{{"scan_strategy", "rings"}, {"skywriting", "0.1"}},
       {"skywriting = 0.1: needs scan_strategy = stripes, islands or hatch"}},
      {{{"layer_gcode", "M100"}}, {"layer_gcode = M100: needs output_format = grbl or marlin"}},
      {{{"gas_flow", "90"}},
       {"gas_flow = 90: needs gas_window above 0, or jump_order = against_gas"}},
      {{{"gas_flow", "90"}, {"jump_order", "against_gas"}}, {}},
      {{{"scan_strategy", "rings"}, {"gas_window", "9"}},
       {"gas_window = 9: needs scan_strategy = stripes, islands or hatch"}},
      {{{"upskin_distance", "0.1"}}, {"upskin_distance = 0.1: needs upskin_layers above 0"}},
      {{{"contours", "0"}, {"contour_start", "rear"}},
       {"contour_start = rear: needs contours above 0"}},
      {{{"contour_run", "0.1"}, {"z_compensation_layers", "2"}, {"recoating_time", "7"}}, {}},
      {{{"laser_spot", "0.1"}, {"contours", "0"}}, {}},  // the report has the unmelted share
      {{{"output_format", "grbl"},
        {"hatch_focus", "1"},
        {"jump_delay", "100"},
        {"laser_dynamic_power", "0"}},
       {}},
      {{{"output_format", "marlin"}, {"jump_speed", "3000"}, {"laser_dynamic_power", "0"}}, {}},
      {{{"hatch_frequency", "20"}, {"hatch_focus", "1"}, {"hatch_power", "100"}}, {}},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.given.back().first);
    const auto resolved = OfLaser(c.given);
    ASSERT_TRUE(resolved.ok()) << resolved.status();
    EXPECT_EQ(TextsOf(resolved->no_effect), c.notes);
  }
}

TEST(ResolveLaser, RefusesWhatCannotBeScanned) {
  struct Case {
    const char* setting;
    Pairs given;
  };
  const Case kCases[] = {{"stripe_width", {{"stripe_width", "0.3"}, {"hatch_distance", "0.4"}}},
                         {"island_width", {{"island_width", "0.3"}, {"hatch_distance", "0.4"}}},
                         {"ring_overlap", {{"ring_overlap", "0.1"}}},
                         {"island_width", {{"upskin_distance", "6"}, {"stripe_width", "7"}}},
                         {"ring_overlap", {{"downskin_distance", "0.01"}}},
                         {"upskin_distance", {{"upskin_distance", "0.0005"}}},
                         {"gas_window", {{"gas_window", "46"}}},
                         {"gas_window", {{"gas_window", "23"}, {"scan_strategy", "islands"}}},
                         {"upskin_power", {{"upskin_power", "500"}, {"output_format", "grbl"}}}};
  for (const auto& [setting, given] : kCases) {
    const ErrorDetail detail = DetailOf(OfLaser(given).status());
    EXPECT_EQ(detail.reason, Reason::kSettingOutOfRange) << setting;
    EXPECT_EQ(detail.metadata.at("setting"), setting);
  }
  EXPECT_TRUE(OfLaser({{"upskin_power", "500"}, {"output_format", "cli"}}).ok());
}

TEST(ResolveLaser, TemplatesAreCheckedBeforeAnyWork) {
  const auto fine = OfLaser({{"output_format", "grbl"},
                             {"start_gcode", "; [model_name]\\nG28"},
                             {"layer_gcode", "M100 Z{layer_z} P[recoating_time]"},
                             {"recoating_time", "9"}});
  ASSERT_TRUE(fine.ok()) << fine.status();
  EXPECT_EQ(ExposureOf(fine->settings).output.start_gcode, "; [model_name]\nG28");
  EXPECT_EQ(ExposureOf(fine->settings).output.recoat_s, 9);
  EXPECT_THAT(TextsOf(fine->no_effect), IsEmpty());
  for (const char* key : {"start_gcode", "before_layer_gcode", "layer_gcode", "end_gcode"}) {
    const ErrorDetail detail =
        DetailOf(OfLaser({{key, "G4\\n[extruded_volume]"}, {"output_format", "marlin"}}).status());
    EXPECT_EQ(detail.reason, Reason::kSettingMalformed);
    EXPECT_EQ(detail.metadata.at("setting"), key);
    EXPECT_EQ(detail.metadata.at("line"), "2");
  }
  // A template of a profile is accepted, although the file format has no place for it.
  EXPECT_TRUE(OfLaser({{"start_gcode", "[extruded_volume]"}}, Source::kProfile).ok());
}

TEST(ResolveLaser, RefusesStripesThatDoNotGetOn) {
  for (const char* key : {"stripe_width", "island_width"}) {
    const ErrorDetail detail = DetailOf(OfLaser({{key, "0.2"}, {"scan_overlap", "0.1"}}).status());
    EXPECT_EQ(detail.reason, Reason::kSettingOutOfRange) << key;
    EXPECT_EQ(detail.metadata.at("setting"), key);
  }
}

}  // namespace
}  // namespace slicefarm::config::laser::laser_settings_test
