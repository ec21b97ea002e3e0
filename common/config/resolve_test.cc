#include "common/config/resolve.h"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "common/base/error.h"
#include "common/base/text.h"
#include "common/config/projects/ini.h"
#include "common/config/setting_pairs_test.h"
#include "common/config/table/settings_table.h"
#include "common/geometry/measure.h"
#include "common/model/limits.h"
#include "common/model/options/adhesion_options.h"
#include "common/model/options/beading_options.h"
#include "common/model/options/infill_options.h"
#include "common/model/options/motion_options.h"
#include "common/model/options/ordering_options.h"
#include "common/model/options/planning_options.h"
#include "common/model/options/tool_row.h"
#include "processes/fdm/model/fdm_settings.h"

namespace slicefarm::config::resolve_test {
namespace {

/// Returns the settings of a plate with one region.
FdmSettings OneRegion(const JobRows& rows) {
  const FdmRows& fdm = FdmOf(rows);
  return {fdm.machine, {fdm.object}, {fdm.region}, {fdm.tool}};
}

using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

ResolvedSettings ResolveOrDie(const std::vector<Setting>& given) {
  auto resolved = Resolve(given, Process::kFdm);
  if (!resolved.ok()) {
    ADD_FAILURE() << resolved.status();
    return {};
  }
  return *std::move(resolved);
}

JobRows Job(const Pairs& pairs) { return ResolveOrDie(Settings(pairs)).settings; }

absl::Status Refusal(const Pairs& pairs, Source source = Source::kRequest) {
  return Resolve(Settings(pairs, source), Process::kFdm).status();
}

std::string ReadCorpus(const std::string& name) {
  std::ifstream file(std::string(SLICEFARM_CORPUS) + "/config/" + name);
  EXPECT_TRUE(file.is_open()) << name;
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

double SpeedOf(const JobRows& settings, Feature feature) {
  return FdmOf(settings).region.motion.speed_mm_s[static_cast<int>(feature)];
}

TEST(Resolve, GivesPrusaSlicersStandardsForNothing) {
  const JobRows s = Job({});
  EXPECT_EQ(s.object.layer_height_nm, 300'000);
  EXPECT_EQ(s.slicing.first_layer_height_nm, 350'000);
  EXPECT_EQ(FdmOf(s).region.walls.inner_width_nm, 450'000);
  EXPECT_EQ(FdmOf(s).region.infill.top_width_nm, 400'000);
  EXPECT_EQ(FdmOf(s).region.walls.first_layer_width_nm, 700'000);
  EXPECT_EQ(s.object.elephant_foot_min_width_nm, 700'000 + 624'889);
  EXPECT_EQ(FdmOf(s).region.infill.top_solid_layers, 3);
  EXPECT_DOUBLE_EQ(FdmOf(s).region.infill.density, 0.2);
  EXPECT_DOUBLE_EQ(FdmOf(s).region.infill.angle_rad, std::numbers::pi / 4);
  EXPECT_EQ(SpeedOf(s, Feature::kExternalPerimeter), 30);
  EXPECT_EQ(FdmOf(s).machine.motion.limits.max_feedrate_mm_s[0], 500);
  EXPECT_EQ(FdmOf(s).tool.temperature_c, 200);
}

// The profile of the benchmarks is read correctly, value by value.
TEST(Resolve, ReadsThePeersProfile) {
  const auto given = ReadIni(ReadCorpus("peers.ini"));
  ASSERT_TRUE(given.ok()) << given.status();
  const ResolvedSettings resolved = ResolveOrDie(*given);
  const JobRows& s = resolved.settings;

  EXPECT_EQ(s.object.layer_height_nm, 200'000);
  EXPECT_EQ(s.slicing.first_layer_height_nm, 200'000);
  EXPECT_EQ(PrintBedShape(s.slicing.bed), "0x0,250x0,250x210,0x210");
  EXPECT_EQ(s.slicing.max_print_height_nm, 210'000'000);
  EXPECT_EQ(s.object.elephant_foot_nm, 0);
  const BeadingOptions walls = {.perimeters = 3,
                                .external_width_nm = 450'000,
                                .inner_width_nm = 450'000,
                                .first_layer_width_nm = 450'000,
                                .thin_walls = false};
  EXPECT_EQ(FdmOf(s).region.walls, walls);
  InfillOptions infill;  // the rest is the model's
  infill.angle_rad = std::numbers::pi / 4;
  infill.walls_nm = 1'350'000;
  infill.zones.skin_width_nm = infill.zones.skeleton_width_nm = 400'000;  // the nozzle's diameter
  EXPECT_EQ(FdmOf(s).region.infill, infill);
  EXPECT_EQ(FdmOf(s).machine.order, OrderingOptions{});

  const MotionOptions m = MotionOf(FdmOf(s));
  EXPECT_EQ(m.flavor, GcodeFlavor::kMarlin2);
  EXPECT_THAT(m.limits.max_feedrate_mm_s, ElementsAre(300, 300, 20, 120));
  EXPECT_THAT(m.limits.max_acceleration_mm_s2, ElementsAre(3000, 3000, 500, 3000));
  EXPECT_THAT(m.limits.max_jerk_mm_s, ElementsAre(8, 8, 0.4, 2.5));
  EXPECT_EQ(m.limits.max_acceleration_extruding_mm_s2, 1000);
  EXPECT_EQ(m.limits.max_acceleration_travel_mm_s2, 3000);
  EXPECT_EQ(m.limits.max_acceleration_retracting_mm_s2, 1500);
  EXPECT_FALSE(m.limits.emit_to_gcode);
  // Values by Feature: walls 40 60, overhangs 40, gaps 40, infill 80 80 40, bridges 40, skirt,
  // support and its interface 60, ironing 15. Solid infill over bridges and bridges over sparse
  // infill have 0: they have the speed of other solid infill and of other bridges.
  EXPECT_THAT(m.speeds[0].speed_mm_s,
              ElementsAre(40, 60, 40, 40, 80, 80, 40, 40, 60, 60, 60, 15, 0, 0));
  EXPECT_EQ(m.speeds[0].small_perimeter_speed_mm_s, 40);
  EXPECT_EQ(m.travel_speed_mm_s, 150);
  EXPECT_EQ(m.first_layer_speed_mm_s, 30);
  EXPECT_EQ(m.first_layer_speed_ratio, 1);
  EXPECT_EQ(m.default_acceleration_mm_s2, 1000);
  EXPECT_THAT(m.acceleration_mm_s2, Each(0));
  const RetractionOptions retraction = {.length_mm = 0.8,
                                        .speed_mm_s = 35,
                                        .restart_speed_mm_s = 35,
                                        .restart_extra_mm = 0,
                                        .min_travel_mm = 2,
                                        .lift_mm = 0};
  EXPECT_EQ(m.tool().retraction, retraction);
  EXPECT_FALSE(m.tool().cooling.enabled);
  EXPECT_TRUE(m.tool().cooling.fan_always_on);
  EXPECT_EQ(m.tool().temperature_c, 210);
  EXPECT_EQ(m.tool().first_layer_temperature_c, 210);
  EXPECT_EQ(m.tool().bed_temperature_c, 60);
  EXPECT_EQ(m.tool().first_layer_bed_temperature_c, 60);
  EXPECT_EQ(m.start_gcode, "G28");
  EXPECT_EQ(m.end_gcode, "M84");
  EXPECT_THAT(resolved.warnings, IsEmpty());
  EXPECT_FALSE(m.writing.relative_e);
  EXPECT_THAT(TextsOf(resolved.no_effect), IsEmpty());
}

// The profile has everything that PrusaSlicer 2.5 writes when it saves its own defaults.
TEST(Resolve, TakesAWholeProfile) {
  const auto given = ReadIni(ReadCorpus("prusaslicer_defaults.ini"));
  ASSERT_TRUE(given.ok()) << given.status();
  ASSERT_GT(given->size(), 250);
  const ResolvedSettings resolved = ResolveOrDie(*given);
  EXPECT_THAT(TextsOf(resolved.no_effect), Not(Contains(HasSubstr(": unknown"))));
  EXPECT_THAT(TextsOf(resolved.no_effect), Contains(HasSubstr("clip_multipart_objects = 1")));
  EXPECT_THAT(resolved.warnings, ElementsAre(HasSubstr("gcode_flavor = reprap")));
  // The entries that a user should read.
  EXPECT_EQ(std::ssize(resolved.no_effect) - resolved.beside_print, 2);
  EXPECT_THAT(TextsOf(resolved.no_effect), Not(Contains(HasSubstr("describes the profile"))));

  // Defaults differ from PrusaSlicer's only for a reason given in the table's documentation.
  JobRows ours = Job({});
  FdmOf(ours).tool.filament_density_g_cm3 = 0;
  FdmOf(ours).machine.plan.skirt.loops = 1;
  FdmOf(ours).region.infill.overlap_nm = 112'500;
  FdmOf(ours).region.infill.shells = ShellThickness::kPartial;
  FdmOf(ours).region.walls.extra_perimeters = true;
  FdmOf(ours).machine.order.travel.hide = false;
  FdmOf(ours).region.infill.pattern = FillPattern::kStars;
  ours.slicing.thumbnails.clear();
  FdmOf(ours).machine.motion.writing.relative_e = false;
  FdmOf(ours).tool.start_filament_gcode = "; Filament gcode\n";
  FdmOf(ours).machine.motion.end_gcode =
      "; Filament-specific end gcode \n;END gcode for filament\n" +
      FdmOf(ours).machine.motion.end_gcode.str();
  const std::optional<MachineLimits>& silent =
      FdmOf(resolved.settings).machine.motion.silent_limits;
  ASSERT_TRUE(silent.has_value());  // silent_mode = 1, with second values of the limits
  EXPECT_THAT(silent->max_feedrate_mm_s, ElementsAre(200, 200, 12, 120));
  FdmOf(ours).machine.motion.silent_limits = silent;
  EXPECT_EQ(EffectiveText(resolved.settings), EffectiveText(ours));
  EXPECT_EQ(resolved.settings, ours);
}

struct DerivedCase {
  std::string name;
  Pairs given;
  std::string key;
  std::string want;
};

class Derived : public testing::TestWithParam<DerivedCase> {};

TEST_P(Derived, ComesTo) {
  const DerivedCase& c = GetParam();
  const ResolvedSettings resolved = ResolveOrDie(Settings(c.given));
  EXPECT_THAT(resolved.effective_text, HasSubstr("\n" + c.key + " = " + c.want + "\n"));
}

INSTANTIATE_TEST_SUITE_P(
    Widths, Derived,
    testing::Values(
        DerivedCase{"AutoIsOneAndAnEighthNozzle",
                    {{"nozzle_diameter", "0.6"}},
                    "perimeter_extrusion_width",
                    "0.675"},
        DerivedCase{"AutoTopIsTheNozzle",
                    {{"nozzle_diameter", "0.6"}},
                    "top_infill_extrusion_width",
                    "0.6"},
        DerivedCase{
            "ZeroFallsBack", {{"extrusion_width", "0.5"}}, "solid_infill_extrusion_width", "0.5"},
        DerivedCase{"OwnWins",
                    {{"extrusion_width", "0.5"}, {"infill_extrusion_width", "0.6"}},
                    "infill_extrusion_width",
                    "0.6"},
        DerivedCase{"PercentOfLayerHeight",
                    {{"layer_height", "0.2"}, {"perimeter_extrusion_width", "210%"}},
                    "perimeter_extrusion_width",
                    "0.42"},
        DerivedCase{"FallBackInPercent",
                    {{"layer_height", "0.2"}, {"extrusion_width", "250%"}},
                    "external_perimeter_extrusion_width",
                    "0.5"},
        DerivedCase{"FirstLayerPercentOfItsHeight",
                    {{"layer_height", "0.2"}, {"first_layer_height", "0.3"}},
                    "first_layer_extrusion_width",
                    "0.6"},
        DerivedCase{"FirstLayerZeroIsThePerimeters",
                    {{"first_layer_extrusion_width", "0"}, {"perimeter_extrusion_width", "0.5"}},
                    "first_layer_extrusion_width",
                    "0.5"},
        DerivedCase{"FirstHeightPercent",
                    {{"layer_height", "0.2"}, {"first_layer_height", "150%"}},
                    "first_layer_height",
                    "0.3"},
        DerivedCase{"OverlapPercentOfPerimeter",
                    {{"infill_overlap", "10%"}, {"perimeter_extrusion_width", "0.5"}},
                    "infill_overlap",
                    "0.05"},
        DerivedCase{
            "OverlapPercentOfAuto", {{"nozzle_diameter", "0.8"}}, "infill_overlap", "0.225"},
        DerivedCase{"OverlapInMm", {{"infill_overlap", "0.15"}}, "infill_overlap", "0.15"}),
    [](const auto& info) { return info.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Speeds, Derived,
    testing::Values(
        DerivedCase{"ExternalPercent",
                    {{"perimeter_speed", "80"}, {"external_perimeter_speed", "60%"}},
                    "external_perimeter_speed",
                    "48"},
        DerivedCase{"SmallPercent",
                    {{"perimeter_speed", "80"}, {"small_perimeter_speed", "25%"}},
                    "small_perimeter_speed",
                    "20"},
        DerivedCase{"SolidPercent",
                    {{"infill_speed", "100"}, {"solid_infill_speed", "80%"}},
                    "solid_infill_speed",
                    "80"},
        DerivedCase{"TopPercentOfPercent",
                    {{"infill_speed", "100"},
                     {"solid_infill_speed", "80%"},
                     {"top_solid_infill_speed", "50%"}},
                    "top_solid_infill_speed",
                    "40"},
        DerivedCase{"ZeroIsMaxPrintSpeed",
                    {{"infill_speed", "0"}, {"max_print_speed", "123"}},
                    "infill_speed",
                    "123"},
        DerivedCase{"PercentOfZeroIsMaxPrintSpeed",
                    {{"perimeter_speed", "0"}, {"max_print_speed", "123"}},
                    "external_perimeter_speed",
                    "123"},
        DerivedCase{
            "FirstLayerPercentStays", {{"first_layer_speed", "40%"}}, "first_layer_speed", "40%"},
        DerivedCase{
            "FirstLayerZeroIsAsAbove", {{"first_layer_speed", "0"}}, "first_layer_speed", "100%"},
        DerivedCase{"ExternalAcceleration",
                    {{"perimeter_acceleration", "800"}},
                    "external_perimeter_acceleration",
                    "800"},
        DerivedCase{"TopAccelerationThroughSolid",
                    {{"infill_acceleration", "900"}},
                    "top_solid_infill_acceleration",
                    "900"},
        DerivedCase{"OwnAccelerationWins",
                    {{"infill_acceleration", "900"}, {"solid_infill_acceleration", "700"}},
                    "top_solid_infill_acceleration",
                    "700"},
        DerivedCase{"LesserVolumetricLimit",
                    {{"max_volumetric_speed", "8"}, {"filament_max_volumetric_speed", "11"}},
                    "filament_max_volumetric_speed",
                    "8"},
        DerivedCase{"OnlyTheFilamentsLimit",
                    {{"filament_max_volumetric_speed", "11"}},
                    "filament_max_volumetric_speed",
                    "11"},
        DerivedCase{"OnlyThePrintsLimit",
                    {{"max_volumetric_speed", "8"}},
                    "filament_max_volumetric_speed",
                    "8"}),
    [](const auto& info) { return info.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Others, Derived,
    testing::Values(
        DerivedCase{"DeretractAsRetract", {{"retract_speed", "33"}}, "deretract_speed", "33"},
        DerivedCase{"FilamentOverrides",
                    {{"retract_length", "0.8"}, {"filament_retract_length", "1.2"}},
                    "retract_length",
                    "1.2"},
        DerivedCase{"NilDoesNot",
                    {{"retract_length", "0.8"}, {"filament_retract_length", "nil"}},
                    "retract_length",
                    "0.8"},
        DerivedCase{"NilTakesBack",
                    {{"filament_retract_length", "1.2"},
                     {"retract_length", "0.8"},
                     {"filament_retract_length", "nil"}},
                    "retract_length",
                    "0.8"},
        DerivedCase{"NilPerExtruder",
                    {{"retract_lift", "0.4"}, {"filament_retract_lift", "nil,nil"}},
                    "retract_lift",
                    "0.4"},
        DerivedCase{"FilamentGcodeAfterStart",
                    {{"start_gcode", "G28"}, {"start_filament_gcode", "\"M900 K0.05\\n\""}},
                    "start_filament_gcode",
                    "\"M900 K0.05\\n\""},
        DerivedCase{"FilamentGcodeBeforeEnd",
                    {{"end_gcode", "M84"}, {"end_filament_gcode", "M900 K0"}},
                    "end_gcode",
                    "M900 K0\\nM84"},
        DerivedCase{"FirstOfAList", {{"temperature", "215,230"}}, "temperature", "215"}),
    [](const auto& info) { return info.param.name; });

TEST(Resolve, LetsLaterSettingsWin) {
  EXPECT_EQ(FdmOf(Job({{"perimeters", "2"}, {"perimeters", "4"}})).region.walls.perimeters, 4);
}

// A correction that an error suggests, or another profile, must be accepted.
TEST(Resolve, LooksAtNoValueThatALaterOneReplaces) {
  const Source kSources[] = {Source::kProfile, Source::kRequest};
  for (const Source last : kSources) {
    for (const Source first : kSources) {
      for (const char* bad : {"-3", "many", "", "1e99"}) {
        const std::vector<Setting> given = {{"perimeters", bad, first}, {"perimeters", "4", last}};
        EXPECT_EQ(FdmOf(ResolveOrDie(given).settings).region.walls.perimeters, 4) << bad;
      }
      const std::vector<Setting> now_bad = {{"perimeters", "4", first}, {"perimeters", "-3", last}};
      EXPECT_EQ(DetailOf(Resolve(now_bad, Process::kFdm).status()).reason,
                Reason::kSettingOutOfRange);
    }
  }
}

TEST(Resolve, SaysThatAValueIsReplacedThoughItIsOutOfRange) {
  EXPECT_THAT(
      TextsOf(ResolveOrDie(Settings({{"perimeters", "-3"}, {"perimeters", "4"}})).no_effect),
      Contains("perimeters = -3: overridden by a later perimeters"));
}

TEST(Resolve, LetsNoEmptyValueOfAProfileReplaceANumber) {
  const Pairs kPairs = {{"perimeters", "4"}, {"perimeters", ""}};
  const ResolvedSettings resolved = ResolveOrDie(Settings(kPairs, Source::kProfile));
  EXPECT_EQ(FdmOf(resolved.settings).region.walls.perimeters, 4);
}

// PrusaSlicer suggests values up to 35 % but accepts larger ones; projects have 60 % and 100 %.
TEST(Resolve, TakesTreesThatCoverAllOfWhatTheyCarry) {
  const JobRows s = Job({{"support_tree_top_rate", "100%"}});
  EXPECT_DOUBLE_EQ(FdmOf(s).object.support.tree.top_rate, 1);
}

// Resolving the text gives the same settings and the same text.
TEST(Resolve, ReadsItsOwnEffectiveText) {
  const std::vector<Pairs> kCases = {
      {},
      {{"layer_height", "0.15"}, {"extrusion_width", "0.47"}, {"first_layer_speed", "37.5%"}},
      {{"gcode_flavor", "klipper"}, {"filament_settings_id", "\"a; \\\"b\\\"\""}},
      {{"fill_angle", "33.333333"},
       {"fill_density", "12.345678%"},
       {"external_perimeter_speed", "33.3333%"}},
      {{"start_gcode", "G28\\n; back\\\\slash\\nG1"}, {"top_solid_min_thickness", "1"}},
      {{"first_layer_height", "0.2"},
       {"layer_height", "0.15"},
       {"bottom_solid_min_thickness", "0.5"}},
      {{"bed_shape", "-10x-10,10x-10,0x17.123457"},
       {"thumbnails", ""},
       {"infill_acceleration", "500"},
       {"default_acceleration", "900"}},
      {{"start_gcode", "\\ \\\tG28\\n G1 \\ "}, {"filament_settings_id", "\" blanks \""}},
      {{"end_filament_gcode", "\" M900 \""}},
      {{"start_filament_gcode", "\" M117 \\\"a;b\\\"\\n\";\"M900\""}},
      {{"filament_retract_length", "0.3"}, {"max_volumetric_speed", "7.5"}, {"infill_speed", "0"}},
  };
  for (const Pairs& given : kCases) {
    const ResolvedSettings first = ResolveOrDie(Settings(given));
    const auto lines = ReadIni(first.effective_text);
    ASSERT_TRUE(lines.ok()) << lines.status();
    const ResolvedSettings second = ResolveOrDie(*lines);
    EXPECT_EQ(second.settings, first.settings);
    EXPECT_EQ(second.effective_text, first.effective_text);
    EXPECT_THAT(TextsOf(second.no_effect), IsEmpty());
    EXPECT_THAT(second.warnings, IsEmpty());
  }
}

TEST(Resolve, GivesOneTextForOneMeaning) {
  const std::string text = ResolveOrDie(Settings({{"layer_height", "0.2"}})).effective_text;
  for (const Pairs& same : {Pairs{{"layer_height", " 0.20 "}}, Pairs{{"layer_height", "2e-1"}},
                            Pairs{{"layer_height", "0.3"}, {"layer_height", "0.2"}},
                            Pairs{{"layer_height", "0.2"}, {"perimeter_speed", "60.0"}},
                            Pairs{{"layer_height", "0.2"}, {"external_perimeter_speed", "30"}}}) {
    EXPECT_EQ(ResolveOrDie(Settings(same)).effective_text, text);
  }
  EXPECT_NE(ResolveOrDie(Settings({{"layer_height", "0.200001"}})).effective_text, text);
}

TEST(Resolve, SortsTheEffectiveText) {
  std::vector<std::string> keys;
  const std::string text = ResolveOrDie({}).effective_text;
  for (const std::string_view line : Split(text, "\n")) {
    if (!line.empty()) keys.emplace_back(line.substr(0, line.find(" = ")));
  }
  EXPECT_GT(keys.size(), 100);
  EXPECT_TRUE(std::is_sorted(keys.begin(), keys.end()));
}

TEST(Resolve, RefusesUnknownKeysOfARequestWithASuggestion) {
  const absl::Status status = Refusal({{"layer_hieght", "0.2"}});
  const ErrorDetail detail = DetailOf(status);
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
  EXPECT_EQ(detail.reason, Reason::kSettingUnknown);
  EXPECT_EQ(detail.metadata.at("setting"), "layer_hieght");
  EXPECT_EQ(detail.metadata.at("suggestion"), "layer_height");
  EXPECT_THAT(std::string(status.message()), HasSubstr("do you mean layer_height?"));
  EXPECT_EQ(DetailOf(Refusal({{"banana", "1"}})).metadata.count("suggestion"), 0);
}

TEST(Resolve, ReportsUnknownKeysOfAProfile) {
  const ResolvedSettings resolved =
      ResolveOrDie(Settings({{"new_in_3_0", "1"}, {"layer_height", "0.2"}}, Source::kProfile));
  EXPECT_THAT(TextsOf(resolved.no_effect), ElementsAre("new_in_3_0 = 1: unknown"));
  EXPECT_EQ(resolved.settings.object.layer_height_nm, 200'000);
}

TEST(Resolve, WarnsOfFeaturesThatAreAskedForAndMissing) {
  for (const auto& [key, value] : Pairs{{"colorprint_heights", "5"}, {"post_process", "/bin/rm"}}) {
    const ResolvedSettings resolved = ResolveOrDie(Settings({{key, value}}, Source::kProfile));
    EXPECT_THAT(TextsOf(resolved.no_effect), ElementsAre(HasSubstr(key + " = " + value))) << key;
    EXPECT_THAT(resolved.warnings, ElementsAre(HasSubstr(key + " = " + value))) << key;
    // A request for a named value is either fulfilled or an error.
    const ErrorDetail detail = DetailOf(Refusal({{key, value}}));
    EXPECT_EQ(detail.reason, Reason::kNotSupported) << key;
    EXPECT_EQ(detail.metadata.at("feature"), key);
    EXPECT_EQ(detail.metadata.at("setting"), key);
  }
  const ResolvedSettings off = ResolveOrDie(Settings(
      {{"colorprint_heights", ""}, {"brim_width", "0"}, {"post_process", ""}, {"skirts", "0"}}));
  EXPECT_THAT(TextsOf(off.no_effect), IsEmpty());
  EXPECT_THAT(off.warnings, IsEmpty());
}

// OrcaSlicer and Bambu Studio write values of features that are off without checking them.
TEST(Resolve, AValueOutOfRangeOfAFeatureThatIsOffRefusesNoProfile) {
  const auto resolve = [](const char* fuzzy, const char* key, const char* value, Source source) {
    return Resolve(Settings({{"fuzzy_skin", fuzzy}, {key, value}}, source), Process::kFdm);
  };
  for (const auto& [key, value] : {std::pair{"fuzzy_skin_thickness", "150"},
                                   {"fuzzy_skin_point_dist", "0"},
                                   {"fuzzy_skin_point_dist", "5000"}}) {
    const auto off = resolve("none", key, value, Source::kProfile);
    ASSERT_TRUE(off.ok()) << off.status();
    EXPECT_THAT(TextsOf(off->no_effect),
                ElementsAre(fmt::format(
                    "{} = {}: out of range, and needs a fuzzy_skin other than none", key, value)));
    const auto standard = Resolve(Settings({{"fuzzy_skin", "none"}}), Process::kFdm);
    EXPECT_EQ(off->effective_text, standard->effective_text);
    for (const absl::Status& refusal : {resolve("external", key, value, Source::kProfile).status(),
                                        resolve("none", key, value, Source::kRequest).status()}) {
      EXPECT_EQ(DetailOf(refusal).reason, Reason::kSettingOutOfRange) << refusal;
      EXPECT_EQ(DetailOf(refusal).metadata["setting"], key);
    }
  }
}

TEST(Resolve, AllThatIsAddedAndTravelStayOutOfExcludedAreas) {
  const auto resolve = [](const char* area) {
    return Resolve(Settings({{"bed_shape", "0x0,256x0,256x256,0x256"}, {"bed_exclude_area", area}}),
                   Process::kFdm);
  };
  const auto cut = resolve("0x0,18x0,18x28,0x28");
  ASSERT_TRUE(cut.ok()) << cut.status();
  const MachineRow& machine = FdmOf(cut->settings).machine;
  EXPECT_EQ(cut->settings.slicing.excluded.size(), 1u);
  EXPECT_DOUBLE_EQ(Area(machine.plan.bed) * 1e-12, 256.0 * 256 - 18 * 28);
  EXPECT_EQ(machine.order.travel.travel_area, machine.plan.bed);
  EXPECT_EQ(machine.motion.travel_area, machine.plan.bed);
  EXPECT_THAT(cut->effective_text, HasSubstr("bed_exclude_area = 0x0,18x0,18x28,0x28\n"));
  const auto none = resolve("0x0");
  ASSERT_TRUE(none.ok()) << none.status();
  EXPECT_TRUE(FdmOf(none->settings).machine.motion.travel_area.empty());
  EXPECT_THAT(none->effective_text, Not(HasSubstr("bed_exclude_area")));
  const auto all = resolve("-1x-1,300x-1,300x300,-1x300");
  ASSERT_FALSE(all.ok());
  EXPECT_EQ(DetailOf(all.status()).reason, Reason::kSettingOutOfRange);
  EXPECT_EQ(DetailOf(all.status()).metadata["setting"], "bed_exclude_area");
}

TEST(Resolve, TheAreaThatCoversTheBedIsNamed) {
  constexpr const char* kNone = "";
  constexpr const char* kAll = "-1x-1,300x-1,300x300,-1x300";
  constexpr const char* kLeft = "-1x-1,100x-1,100x300,-1x300";
  constexpr const char* kRight = "90x-1,300x-1,300x300,90x300";
  const auto named = [](const char* excluded, const char* wrapping) {
    return DetailOf(Refusal({{"bed_shape", "0x0,256x0,256x256,0x256"},
                             {"enable_wrapping_detection", "1"},
                             {"bed_exclude_area", excluded},
                             {"wrapping_exclude_area", wrapping}}))
        .metadata["setting"];
  };
  EXPECT_EQ(named(kNone, kAll), "wrapping_exclude_area");
  EXPECT_EQ(named(kLeft, kAll), "wrapping_exclude_area");
  EXPECT_EQ(named(kAll, kNone), "bed_exclude_area");
  EXPECT_EQ(named(kLeft, kRight), "bed_exclude_area") << "together with the other area";
}

TEST(Resolve, SkirtBrimAndRaftTakeWidthsAndHeightsOfOtherSettings) {
  const JobRows settings = ResolveOrDie(Settings({{"first_layer_height", "0.25"},
                                                  {"first_layer_extrusion_width", "0.5"},
                                                  {"layer_height", "0.2"},
                                                  {"nozzle_diameter", "0.6"},
                                                  {"filament_diameter", "2"},
                                                  {"bed_shape", "0x0,90x0,90x90"},
                                                  {"raft_layers", "3"},
                                                  {"raft_contact_distance", "0.15"},
                                                  {"skirts", "2"},
                                                  {"brim_width", "4"}}))
                               .settings;
  const SkirtOptions& skirt = FdmOf(settings).machine.plan.skirt;
  EXPECT_EQ(skirt.loops, 2);
  EXPECT_EQ(skirt.width_nm, 500'000);
  EXPECT_EQ(skirt.height_nm, 250'000);
  EXPECT_DOUBLE_EQ(skirt.filament_area_mm2, 3.14159265358979323846);
  const ObjectPlanOptions& object = FdmOf(settings).object;
  EXPECT_EQ(object.brim.type, BrimType::kOuterOnly);
  EXPECT_EQ(object.brim.line_width_nm, 500'000);
  EXPECT_EQ(object.raft.heights, (RaftHeights{3, 250'000, 450'000, 150'000}));
  EXPECT_EQ(object.raft.lines.width_nm, 600'000);
  EXPECT_EQ(object.raft_settings.size(), 3u);
  EXPECT_FALSE(settings.object.on_bed);
  EXPECT_EQ(settings.object.lift_nm, object.raft.heights.LiftNm());
  EXPECT_EQ(FdmOf(settings).machine.plan.bed, (MultiPolygon{{settings.slicing.bed, {}}}));
  EXPECT_TRUE(FdmOf(settings).machine.motion.travel_area.empty());
}

// PrusaSlicer differs: its default is one skirt.
TEST(Resolve, NothingIsAddedToThePlateUnasked) {
  const FdmRows rows = FdmOf(ResolveOrDie({}).settings);
  EXPECT_EQ(rows.machine.plan.skirt.loops, 0);
  EXPECT_EQ(rows.object.brim.width_nm, 0);
  EXPECT_EQ(rows.object.raft.heights.layers, 0);
}

TEST(Resolve, TakesTheNearestForAProfilesUnsupportedChoice) {
  const ResolvedSettings resolved =
      ResolveOrDie(Settings({{"gcode_flavor", "reprap"}}, Source::kProfile));
  EXPECT_EQ(FdmOf(resolved.settings).machine.motion.flavor, GcodeFlavor::kMarlin2);
  EXPECT_THAT(resolved.warnings,
              ElementsAre("gcode_flavor = reprap: not supported yet: marlin2 is used"));
  EXPECT_EQ(TextsOf(resolved.no_effect), resolved.warnings);
}

TEST(Resolve, AFieldByDistanceLooksAsManyLayersAwayAsItReaches) {
  const std::string field = R"({"kind":"surface_distance","near":0.5,"far":0.1,"length":4.1})";
  const JobRows settings = Job({{"density_field", field}, {"layer_height", "0.2"}});
  EXPECT_EQ(FdmOf(settings).region.infill.density_field, field);
  EXPECT_EQ(FdmOf(settings).region.infill.field_halo_layers, 21);
  EXPECT_GE(HaloLayers(OneRegion(settings)), 21);
  EXPECT_EQ(FdmOf(Job({{"density_field", R"({"kind":"constant","density":1})"}}))
                .region.infill.field_halo_layers,
            0);
  const absl::Status far = Refusal({{"density_field", field}, {"layer_height", "0.02"}});
  EXPECT_EQ(DetailOf(far).reason, Reason::kSettingOutOfRange);
  EXPECT_EQ(DetailOf(far).metadata.at("setting"), "density_field");
}

TEST(Resolve, RefusesFieldsThatAreNone) {
  for (const char* key : {"density_field", "stress_field", "material_field"}) {
    const absl::Status status = Refusal({{key, R"({"kind":"nothing"})"}});
    EXPECT_EQ(DetailOf(status).reason, Reason::kSettingMalformed) << key;
    EXPECT_EQ(DetailOf(status).metadata.at("setting"), key);
  }
  const absl::Status large = Refusal({{"density_field", std::string(limits::kMaxFieldBytes, ' ')}});
  EXPECT_EQ(DetailOf(large).reason, Reason::kRequestTooLarge);
}

TEST(Resolve, RefusesFieldsThatDoNotGoTogether) {
  const char* stress = R"({"kind":"constant","stress":[1,0,0]})";
  const char* cells = R"({"kind":"constant","density":0.2,"dither":"blue_noise"})";
  EXPECT_EQ(DetailOf(Refusal({{"stress_field", stress}, {"density_field", cells}})).reason,
            Reason::kSettingOutOfRange);
  const char* half = R"({"kind":"constant","density":0.5})";
  const std::string mix = std::string("{\"parts\":[") + half + "," + half + "]}";
  EXPECT_TRUE(Refusal({{"material_field", mix}}).ok());
  EXPECT_EQ(DetailOf(Refusal({{"material_field", mix}, {"gcode_flavor", "klipper"}})).reason,
            Reason::kSettingOutOfRange);
}

TEST(Resolve, JobsWithoutFieldsDoNotSaySo) {
  EXPECT_THAT(ResolveOrDie({}).effective_text, Not(HasSubstr("_field")));
  EXPECT_THAT(ResolveOrDie(Settings({{"density_field", R"({"kind": "constant", "density": 0.5})"}}))
                  .effective_text,
              HasSubstr("density_field = {\"kind\":\"height\",\"table\":[[0,0.5]]}\n"));
}

TEST(Resolve, EveryPatternHasItsNameInSettings) {
  for (const FillPatternInfo& info : kFillPatterns) {
    const std::string name(info.name);
    if (info.sparse) {
      EXPECT_EQ(
          FdmOf(ResolveOrDie(Settings({{"fill_pattern", name}})).settings).region.infill.pattern,
          info.pattern);
    }
    for (const char* key : {"top_fill_pattern", "bottom_fill_pattern", "solid_fill_pattern"})
      EXPECT_EQ(Refusal({{key, name}}).ok(), info.solid != SolidFillStyle::kNone)
          << key << ' ' << name;
  }
}

TEST(Resolve, AnchorsAreSharesOfTheInfillsWidth) {
  const InfillOptions standard = FdmOf(ResolveOrDie(Settings({})).settings).region.infill;
  EXPECT_EQ(standard.anchor_nm, 6 * standard.sparse_width_nm);
  EXPECT_EQ(standard.anchor_max_nm, 50 * kNmPerMm);
  const InfillOptions given =
      FdmOf(ResolveOrDie(Settings({{"infill_anchor", "1.5"}, {"infill_anchor_max", "1000%"}}))
                .settings)
          .region.infill;
  EXPECT_EQ(given.anchor_nm, FromMm(1.5));
  EXPECT_EQ(given.anchor_max_nm, 10 * given.sparse_width_nm);
}

TEST(Resolve, ReadsWhatInfillTakesFromTheWholePart) {
  const InfillOptions automatic =
      FdmOf(ResolveOrDie(Settings({{"fill_pattern", "auto"}, {"infill_goal", "time"}})).settings)
          .region.infill;
  EXPECT_TRUE(automatic.choose_pattern);
  EXPECT_EQ(automatic.goal, FillGoal::kTime);
  const ResolvedSettings given = ResolveOrDie(Settings({{"fill_pattern", "lightning"},
                                                        {"fill_angle_template", "0, 45,+30"},
                                                        {"solid_fill_angle_template", "90"},
                                                        {"layer_height", "0.2"},
                                                        {"infill_every_layers", "2"},
                                                        {"infill_only_where_needed", "1"},
                                                        {"bridge_flow_ratio", "0.9"},
                                                        {"thick_bridges", "0"},
                                                        {"interface_shells", "1"},
                                                        {"ironing", "1"},
                                                        {"ironing_type", "solid"},
                                                        {"ironing_flowrate", "20%"},
                                                        {"ironing_spacing", "0.2"},
                                                        {"ironing_speed", "22"}}));
  const InfillOptions& infill = FdmOf(given.settings).region.infill;
  EXPECT_FALSE(infill.choose_pattern);
  EXPECT_EQ(infill.pattern, FillPattern::kLightning);
  EXPECT_EQ(infill.angle_template, "0,45,+30");
  EXPECT_EQ(infill.solid_angle_template, "90");
  EXPECT_EQ(infill.every_layers, 2);
  EXPECT_TRUE(infill.only_where_needed);
  EXPECT_EQ(infill.bridge_flow, 0.9);
  EXPECT_FALSE(infill.thick_bridges);
  EXPECT_TRUE(infill.interface_shells);
  EXPECT_EQ(infill.ironing, (IroningOptions{true, IroningType::kSolid, 0.2, 200'000}));
  EXPECT_EQ(FdmOf(given.settings).region.motion.speed_mm_s[static_cast<size_t>(Feature::kIroning)],
            22);
  EXPECT_THAT(TextsOf(given.no_effect), IsEmpty());
  // Reading the effective text gives the same values.
  EXPECT_THAT(given.effective_text, HasSubstr("\nfill_angle_template = 0,45,+30\n"));
  EXPECT_THAT(ResolveOrDie(Settings({{"fill_pattern", "auto"}})).effective_text,
              HasSubstr("\nfill_pattern = auto\n"));
}

// Solid infill over bridges is a separate feature if it has a speed of its own. It then depends on
// two layers below.
TEST(Resolve, ReadsTheSpeedOverBridges) {
  constexpr auto kFeature = static_cast<size_t>(Feature::kSolidOverBridge);
  const std::vector<Setting> flat = Settings({{"bottom_solid_layers", "1"},
                                              {"top_solid_layers", "1"},
                                              {"fill_density", "50%"},
                                              {"perimeter_generator", "classic"}});
  const JobRows without = ResolveOrDie(flat).settings;
  EXPECT_FALSE(FdmOf(without).region.infill.over_bridges);
  EXPECT_EQ(HaloLayers(OneRegion(without)), 1);
  std::vector<Setting> given = flat;
  given.push_back({"over_bridge_speed", "50%"});
  given.push_back({"solid_infill_speed", "44"});
  given.push_back({"default_acceleration", "900"});
  given.push_back({"solid_infill_acceleration", "700"});
  const ResolvedSettings with = ResolveOrDie(given);
  EXPECT_TRUE(FdmOf(with.settings).region.infill.over_bridges);
  EXPECT_EQ(HaloLayers(OneRegion(with.settings)), 2);
  EXPECT_EQ(FdmOf(with.settings).region.motion.speed_mm_s[kFeature], 22);
  EXPECT_EQ(FdmOf(with.settings).machine.motion.acceleration_mm_s2[kFeature], 700);
  EXPECT_THAT(TextsOf(with.no_effect), IsEmpty());
  EXPECT_THAT(with.effective_text, HasSubstr("\nover_bridge_speed = 22\n"));
}

TEST(Resolve, ReadsTheFlowOfShortLines) {
  constexpr const char* kFlag = "small_area_infill_flow_compensation";
  constexpr const char* kTable = "small_area_infill_flow_compensation_model";
  const ResolvedSettings given =
      ResolveOrDie(Settings({{kFlag, "1"}, {kTable, R"("0,0.50";"\n2,0.9";"\n8,1")"}}));
  EXPECT_TRUE(FdmOf(given.settings).region.infill.small_area_flow);
  EXPECT_EQ(FdmOf(given.settings).region.infill.small_area_flow_table, "0,0.5;2,0.9;8,1");
  EXPECT_THAT(given.effective_text, HasSubstr("_model = 0,0.5;2,0.9;8,1\n"));
  EXPECT_THAT(TextsOf(given.no_effect), IsEmpty());
  EXPECT_THAT(TextsOf(ResolveOrDie(Settings({{kTable, "0,0;3,1"}})).no_effect),
              ElementsAre(HasSubstr("needs small_area_infill_flow_compensation = 1")));
  const auto refused = Resolve(Settings({{kTable, "0,0;3,0.9"}}), Process::kFdm);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(DetailOf(refused.status()).reason, Reason::kSettingMalformed);
  EXPECT_EQ(DetailOf(refused.status()).metadata.at("setting"), kTable);
}

TEST(Resolve, LayersPrintedAtOnceAreNoHigherThanTheNozzleIsWide) {
  const ResolvedSettings resolved = ResolveOrDie(Settings(
      {{"infill_every_layers", "5"}, {"layer_height", "0.15"}, {"nozzle_diameter", "0.4"}}));
  EXPECT_EQ(FdmOf(resolved.settings).region.infill.every_layers, 2);
  EXPECT_THAT(TextsOf(resolved.no_effect), ElementsAre("infill_every_layers = 5: layer_height and "
                                                       "nozzle_diameter allow only 2"));
}

TEST(Resolve, LinesOfTheWholePartFollowNoField) {
  for (const char* pattern : {"auto", "adaptivecubic", "supportcubic", "lightning"}) {
    const auto refused =
        Resolve(Settings({{"fill_pattern", pattern},
                          {"density_field", R"({"kind":"constant","density":0.3})"}}),
                Process::kFdm);
    EXPECT_EQ(DetailOf(refused.status()).reason, Reason::kSettingOutOfRange) << pattern;
  }
}

TEST(Resolve, RefusesAnglesThatAreNone) {
  const auto refused = Resolve(Settings({{"fill_angle_template", "0,x"}}), Process::kFdm);
  EXPECT_EQ(DetailOf(refused.status()).reason, Reason::kSettingMalformed);
}

TEST(Resolve, TakesAllPictureFormats) {
  const ResolvedSettings resolved = ResolveOrDie(Settings(
      {{"thumbnails", "16x16/QOI, 313x173/COLPIC, 640x480"}, {"thumbnails_format", "BTT_TFT"}},
      Source::kProfile));
  EXPECT_THAT(resolved.effective_text,
              HasSubstr("thumbnails = 16x16/QOI,313x173/COLPIC,640x480/BTT_TFT\n"));
  EXPECT_THAT(resolved.warnings, IsEmpty());
}

TEST(Resolve, ThumbnailsTakeTheFormatThatTheyDoNotName) {
  const ResolvedSettings resolved =
      ResolveOrDie(Settings({{"thumbnails", "16x16, 313x173/PNG"}, {"thumbnails_format", "QOI"}}));
  EXPECT_THAT(resolved.settings.slicing.thumbnails,
              ElementsAre(ThumbnailSize{16, 16, PictureFormat::kQoi}, ThumbnailSize{313, 173}));
}

TEST(Resolve, SlowsOverhangsDownByDegree) {
  const MotionOptions motion =
      MotionOf(FdmOf(ResolveOrDie(Settings({{"external_perimeter_speed", "40"},
                                            {"enable_dynamic_overhang_speeds", "1"},
                                            {"overhang_speed_1", "50%"},
                                            {"overhang_fan_speed_3", "70"},
                                            {"first_layer_infill_speed", "25%"},
                                            {"solid_infill_speed", "60"}}))
                         .settings));
  EXPECT_TRUE(motion.speeds[0].dynamic_overhangs);
  EXPECT_EQ(motion.speeds[0].overhang_speed_mm_s, (std::array<double, 4>{15, 20, 20, 25}));
  EXPECT_EQ(motion.tool().cooling.overhang_fan_percent, (std::array<int32_t, 4>{0, 0, 0, 70}));
  EXPECT_EQ(motion.first_layer_infill_speed_mm_s, 15);
}

TEST(Resolve, RefusesARequestsUnsupportedChoiceNamingTheOthers) {
  const absl::Status status = Refusal({{"gcode_flavor", "sailfish"}});
  EXPECT_EQ(DetailOf(status).reason, Reason::kNotSupported);
  EXPECT_EQ(DetailOf(status).metadata.at("feature"), "gcode_flavor=sailfish");
  EXPECT_THAT(std::string(status.message()), HasSubstr("one of marlin"));
  EXPECT_EQ(DetailOf(Refusal({{"fill_pattern", "spaghetti"}}, Source::kProfile)).reason,
            Reason::kSettingMalformed);
}

TEST(Resolve, SaysThatOnlyTheFirstExtruderCounts) {
  EXPECT_THAT(ResolveOrDie(Settings({{"temperature", "210,215"}})).warnings,
              ElementsAre(HasSubstr("only the first value, 210")));
  EXPECT_THAT(ResolveOrDie(Settings({{"filament_type", "PLA;PETG"}})).warnings,
              ElementsAre(HasSubstr("only the first value, PLA")));
  EXPECT_THAT(TextsOf(ResolveOrDie(Settings({{"temperature", "210,210"}})).no_effect), IsEmpty());
  const ResolvedSettings modes = ResolveOrDie(Settings({{"machine_max_feedrate_x", "500,200"}}));
  EXPECT_THAT(modes.warnings, IsEmpty());
  EXPECT_THAT(TextsOf(modes.no_effect), ElementsAre(HasSubstr("only the first value, 500")));
}

TEST(Resolve, SilentModeHasTheSecondValues) {
  Pairs given = {{"gcode_flavor", "marlin"},
                 {"silent_mode", "1"},
                 {"machine_max_feedrate_x", "500,200"},
                 {"machine_max_acceleration_extruding", "1250,960"},
                 {"machine_max_jerk_e", "7"}};
  const ResolvedSettings resolved = ResolveOrDie(Settings(given));
  EXPECT_THAT(TextsOf(resolved.no_effect), IsEmpty());
  const MotionOptions motion = MotionOf(FdmOf(resolved.settings));
  ASSERT_TRUE(motion.silent_limits.has_value());
  MachineLimits expected = motion.limits;
  EXPECT_EQ(expected.max_feedrate_mm_s[0], 500);
  expected.max_feedrate_mm_s[0] = 200;
  expected.max_acceleration_extruding_mm_s2 = 960;
  EXPECT_EQ(*motion.silent_limits, expected) << "a list of one value holds for both";
  given[0].second = "klipper";
  EXPECT_FALSE(FdmOf(ResolveOrDie(Settings(given)).settings).machine.motion.silent_limits)
      << "has no such mode";
  given[0].second = "marlin";
  given[1].second = "0";
  EXPECT_FALSE(FdmOf(ResolveOrDie(Settings(given)).settings).machine.motion.silent_limits);
  given[1].second = "1";
  given[2].second = "500,fast";
  EXPECT_FALSE(Refusal(given).ok());
}

TEST(Resolve, ReportsRepetitionsWithinOneSourceOnly) {
  const std::vector<Setting> twice =
      Settings({{"perimeters", "2"}, {"perimeters", "4"}}, Source::kProfile);
  EXPECT_THAT(TextsOf(ResolveOrDie(twice).no_effect),
              ElementsAre("perimeters = 2: overridden by a later perimeters"));
  const std::vector<Setting> over = {{"perimeters", "2", Source::kProfile},
                                     {"perimeters", "4", Source::kRequest}};
  EXPECT_THAT(TextsOf(ResolveOrDie(over).no_effect), IsEmpty());
}

TEST(Resolve, WarnsOfADensityThatLacksItsPercentSign) {
  const ResolvedSettings resolved = ResolveOrDie(Settings({{"fill_density", "0.4"}}));
  EXPECT_DOUBLE_EQ(FdmOf(resolved.settings).region.infill.density, 0.004);
  EXPECT_THAT(resolved.warnings, ElementsAre(HasSubstr("if you mean 40%, write the percent sign")));
  EXPECT_THAT(ResolveOrDie(Settings({{"fill_density", "40"}})).warnings, IsEmpty());
  EXPECT_THAT(ResolveOrDie(Settings({{"fill_density", "0.4%"}})).warnings, IsEmpty());
}

TEST(Resolve, ChecksWhatAPercentageComesTo) {
  const absl::Status status = Refusal({{"layer_height", "0.2"}, {"first_layer_height", "9000%"}});
  EXPECT_EQ(DetailOf(status).reason, Reason::kSettingOutOfRange);
  EXPECT_EQ(DetailOf(status).metadata.at("value"), "9000%");
  EXPECT_THAT(std::string(status.message()), HasSubstr("that is, 18"));
  EXPECT_FALSE(Refusal({{"external_perimeter_speed", "-5%"}}).ok());
}

struct ConflictCase {
  std::string name;
  Pairs given;
  std::string setting;
  std::string says;
};

class Conflict : public testing::TestWithParam<ConflictCase> {};

TEST_P(Conflict, IsRefusedNamingBothSettings) {
  const ConflictCase& c = GetParam();
  const absl::Status status = Refusal(c.given);
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(DetailOf(status).reason, Reason::kSettingOutOfRange);
  EXPECT_EQ(DetailOf(status).metadata.at("setting"), c.setting);
  EXPECT_THAT(std::string(status.message()), HasSubstr(c.setting + " = "));
  EXPECT_THAT(std::string(status.message()), HasSubstr(c.says));
}

INSTANTIATE_TEST_SUITE_P(Settings, Conflict,
                         testing::Values(ConflictCase{"LayerOverNozzle",
                                                      {{"layer_height", "0.41"}},
                                                      "layer_height",
                                                      "nozzle_diameter = 0.4 mm"},
                                         ConflictCase{"FirstLayerOverNozzle",
                                                      {{"first_layer_height", "0.5"}},
                                                      "first_layer_height",
                                                      "nozzle_diameter = 0.4 mm"},
                                         ConflictCase{"WidthUnderHeight",
                                                      {{"infill_extrusion_width", "0.29"}},
                                                      "infill_extrusion_width",
                                                      "layer_height = 0.3 mm"},
                                         ConflictCase{"FirstWidthUnderHeight",
                                                      {{"first_layer_extrusion_width", "0.349"}},
                                                      "first_layer_extrusion_width",
                                                      "first_layer_height = 0.35 mm"},
                                         ConflictCase{"WidthOverThreeNozzles",
                                                      {{"perimeter_extrusion_width", "1.2"}},
                                                      "perimeter_extrusion_width",
                                                      "1.2 mm"},
                                         ConflictCase{"NoRetractionSpeed",
                                                      {{"retract_speed", "0"}},
                                                      "retract_speed",
                                                      "retract_length"},
                                         ConflictCase{"Gaps",
                                                      {{"gap_fill_min_width", "0.9"}},
                                                      "gap_fill_min_width",
                                                      "gap_fill_max_width = 0.8 mm"}),
                         [](const auto& info) { return info.param.name; });

TEST(Resolve, AllowsTheBounds) {
  EXPECT_TRUE(Refusal({{"layer_height", "0.4"}, {"first_layer_height", "0.4"}}).ok());
  EXPECT_TRUE(Refusal({{"perimeter_extrusion_width", "1.199"}}).ok());
  EXPECT_TRUE(Refusal({{"retract_speed", "0"}, {"retract_length", "0"}}).ok());
}

TEST(Resolve, BoundsNumberAndSize) {
  const std::vector<Setting> many(limits::kMaxSettings + 1, {"perimeters", "3"});
  EXPECT_EQ(DetailOf(Resolve(many, Process::kFdm).status()).reason, Reason::kRequestTooLarge);
  const std::string big(limits::kMaxSettingBytes + 1, 'x');
  EXPECT_EQ(DetailOf(Refusal({{"start_gcode", big}})).reason, Reason::kRequestTooLarge);
  EXPECT_EQ(DetailOf(Refusal({{big, "1"}})).reason, Reason::kRequestTooLarge);
  const std::string half(limits::kMaxSettingBytes / 2 + 1, 'x');  // two that become one
  const absl::Status refusal = Refusal({{"end_gcode", half}, {"end_filament_gcode", half}});
  EXPECT_EQ(DetailOf(refusal).reason, Reason::kRequestTooLarge) << refusal;
  EXPECT_THAT(std::string(refusal.message()), HasSubstr("end_gcode"));
}

TEST(Resolve, CompleteObjectsAreArrangedWithRoomForTheHead) {
  const auto slicing = [](const std::vector<std::pair<std::string, std::string>>& given) {
    return ResolveOrDie(Settings(given)).settings.slicing;
  };
  EXPECT_EQ(slicing({}).clearance_radius_nm, 0);
  EXPECT_EQ(slicing({{"complete_objects", "1"}}).clearance_radius_nm, FromMm(20));
  EXPECT_EQ(
      slicing({{"complete_objects", "1"}, {"extruder_clearance_radius", "35"}}).clearance_radius_nm,
      FromMm(35));
  EXPECT_EQ(slicing({{"duplicate_distance", "8.5"}}).part_distance_nm, FromMm(8.5));
}

TEST(Resolve, ShortensLongValuesInReports) {
  const ResolvedSettings resolved =
      ResolveOrDie(Settings({{"no_such_key", std::string(1000, 'n')}}, Source::kProfile));
  ASSERT_EQ(resolved.no_effect.size(), 1);
  EXPECT_LT(resolved.no_effect[0].text.size(), 150);
}

}  // namespace
}  // namespace slicefarm::config::resolve_test
