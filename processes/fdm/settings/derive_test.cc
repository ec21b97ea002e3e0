#include "processes/fdm/settings/derive.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/config/resolve.h"
#include "common/model/limits.h"
#include "processes/fdm/model/fdm_settings.h"
#include "processes/fdm/settings/draft_of_test.h"

namespace slicefarm::config::fdm::derive_test {
namespace {

absl::Status Derived(SettingValues& draft) {
  ResolvedSettings result;
  return Derive(draft, result);
}

struct NumberCase {
  std::string name;
  Pairs given;
  std::string key;
  double want;
};
class DerivedNumber : public testing::TestWithParam<NumberCase> {};

TEST_P(DerivedNumber, StandsForItself) {
  const NumberCase& c = GetParam();
  SettingValues draft = DraftOf(c.given);
  ASSERT_TRUE(Derived(draft).ok());
  EXPECT_DOUBLE_EQ(draft.Number(c.key), c.want);
  EXPECT_FALSE(draft.At(c.key).value->percent);
}

std::string NameOf(const testing::TestParamInfo<NumberCase>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(
    Heights, DerivedNumber,
    testing::Values(
        NumberCase{"FirstLayerInMm", {{"first_layer_height", "0.2"}}, "first_layer_height", 0.2},
        NumberCase{"FirstLayerInPercent",
                   {{"first_layer_height", "75%"}, {"layer_height", "0.2"}},
                   "first_layer_height",
                   0.15}),
    NameOf);

// 0 means extrusion_width, and if it is also 0, 1.125 nozzle diameters; for top infill, one nozzle
// diameter.
INSTANTIATE_TEST_SUITE_P(
    Widths, DerivedNumber,
    testing::Values(
        NumberCase{"Auto", {{"nozzle_diameter", "0.8"}}, "infill_extrusion_width", 0.9},
        NumberCase{"AutoOfTop", {{"nozzle_diameter", "0.8"}}, "top_infill_extrusion_width", 0.8},
        NumberCase{"Own", {{"perimeter_extrusion_width", "0.5"}}, "perimeter_extrusion_width", 0.5},
        NumberCase{"OwnInPercentOfLayers",
                   {{"perimeter_extrusion_width", "250%"}, {"layer_height", "0.2"}},
                   "perimeter_extrusion_width",
                   0.5},
        NumberCase{
            "General", {{"extrusion_width", "0.6"}}, "external_perimeter_extrusion_width", 0.6},
        NumberCase{"GeneralInPercent",
                   {{"extrusion_width", "200%"}, {"layer_height", "0.25"}},
                   "top_infill_extrusion_width",
                   0.5},
        NumberCase{"OwnBeforeGeneral",
                   {{"extrusion_width", "0.6"}, {"solid_infill_extrusion_width", "0.5"}},
                   "solid_infill_extrusion_width",
                   0.5},
        NumberCase{"GeneralItself",
                   {{"extrusion_width", "150%"}, {"layer_height", "0.2"}},
                   "extrusion_width",
                   0.3},
        NumberCase{"FirstLayerOfItsOwnHeight",
                   {{"first_layer_extrusion_width", "200%"},
                    {"first_layer_height", "50%"},
                    {"layer_height", "0.3"}},
                   "first_layer_extrusion_width",
                   0.3},
        NumberCase{"FirstLayerOfThePerimeters",
                   {{"first_layer_extrusion_width", "0"}, {"perimeter_extrusion_width", "0.55"}},
                   "first_layer_extrusion_width",
                   0.55},
        NumberCase{"FirstLayerOfAutoPerimeters",
                   {{"first_layer_extrusion_width", "0"}},
                   "first_layer_extrusion_width",
                   0.45}),
    NameOf);

INSTANTIATE_TEST_SUITE_P(
    VariableWalls, DerivedNumber,
    testing::Values(
        NumberCase{"LeastBead", {{"min_bead_width", "85%"}}, "min_bead_width", 0.34},
        NumberCase{"GreatestBead", {{"nozzle_diameter", "0.6"}}, "max_bead_width", 1.2},
        NumberCase{"LeastFeature", {{"min_feature_size", "50%"}}, "min_feature_size", 0.2},
        NumberCase{
            "Transition", {{"wall_transition_length", "0.7"}}, "wall_transition_length", 0.7},
        NumberCase{"Deviation",
                   {{"wall_transition_filter_deviation", "25%"}},
                   "wall_transition_filter_deviation",
                   0.1},
        NumberCase{"OverlapOfDerivedWidth",
                   {{"infill_overlap", "20%"}, {"extrusion_width", "0.5"}},
                   "infill_overlap",
                   0.1}),
    NameOf);

// Percentages refer to the other setting's value as given. A result of 0 is replaced by
// max_print_speed afterwards.
INSTANTIATE_TEST_SUITE_P(
    Speeds, DerivedNumber,
    testing::Values(
        NumberCase{"Percent",
                   {{"external_perimeter_speed", "50%"}, {"perimeter_speed", "44"}},
                   "external_perimeter_speed",
                   22},
        NumberCase{"PercentOfPercent",
                   {{"infill_speed", "100"},
                    {"solid_infill_speed", "50%"},
                    {"top_solid_infill_speed", "50%"}},
                   "top_solid_infill_speed",
                   25},
        NumberCase{"Auto", {{"bridge_speed", "0"}, {"max_print_speed", "33"}}, "bridge_speed", 33},
        NumberCase{
            "PercentOfAuto",
            {{"perimeter_speed", "0"}, {"small_perimeter_speed", "50%"}, {"max_print_speed", "70"}},
            "small_perimeter_speed",
            70},
        NumberCase{"OverBridgesOfSolids",
                   {{"over_bridge_speed", "40%"}, {"solid_infill_speed", "50"}},
                   "over_bridge_speed",
                   20},
        NumberCase{"InternalBridgesOfBridges",
                   {{"internal_bridge_speed", "150%"}, {"bridge_speed", "20"}},
                   "internal_bridge_speed",
                   30},
        NumberCase{"OverBridgesAsSolids", {{"solid_infill_speed", "50"}}, "over_bridge_speed", 0},
        NumberCase{"Own", {{"gap_fill_speed", "11"}}, "gap_fill_speed", 11}),
    NameOf);

INSTANTIATE_TEST_SUITE_P(Accelerations, DerivedNumber,
                         testing::Values(NumberCase{"OfOuterWalls",
                                                    {{"perimeter_acceleration", "700"}},
                                                    "external_perimeter_acceleration",
                                                    700},
                                         NumberCase{"OfTopsOverSolids",
                                                    {{"infill_acceleration", "900"}},
                                                    "top_solid_infill_acceleration",
                                                    900},
                                         NumberCase{"OfTopsFromSolids",
                                                    {{"infill_acceleration", "900"},
                                                     {"solid_infill_acceleration", "800"}},
                                                    "top_solid_infill_acceleration",
                                                    800},
                                         NumberCase{"Own",
                                                    {{"perimeter_acceleration", "700"},
                                                     {"external_perimeter_acceleration", "300"}},
                                                    "external_perimeter_acceleration",
                                                    300},
                                         NumberCase{
                                             "None", {}, "external_perimeter_acceleration", 0}),
                         NameOf);

INSTANTIATE_TEST_SUITE_P(
    Combination, DerivedNumber,
    testing::Values(
        NumberCase{"OfItselfTakesNoMore", {{"layer_height", "0.1"}}, "infill_every_layers", 1},
        NumberCase{"AsHighAsTheNozzleIsWide",
                   {{"automatic_infill_combination", "1"}, {"layer_height", "0.1"}},
                   "infill_every_layers",
                   4},
        NumberCase{"AsHighAsAsked",
                   {{"automatic_infill_combination", "1"},
                    {"automatic_infill_combination_max_layer_height", "0.35"},
                    {"layer_height", "0.1"}},
                   "infill_every_layers",
                   3},
        NumberCase{"ByTheNozzle",
                   {{"automatic_infill_combination", "1"},
                    {"automatic_infill_combination_max_layer_height", "75%"},
                    {"nozzle_diameter", "0.8"},
                    {"layer_height", "0.2"}},
                   "infill_every_layers",
                   3},
        NumberCase{"NoHigherThanTheNozzleIsWide",
                   {{"automatic_infill_combination", "1"},
                    {"automatic_infill_combination_max_layer_height", "2"},
                    {"layer_height", "0.15"}},
                   "infill_every_layers",
                   2},
        NumberCase{"TakesThePlaceOfWhatIsGiven",
                   {{"automatic_infill_combination", "1"},
                    {"infill_every_layers", "2"},
                    {"layer_height", "0.1"}},
                   "infill_every_layers",
                   4}),
    NameOf);

INSTANTIATE_TEST_SUITE_P(
    Filament, DerivedNumber,
    testing::Values(
        NumberCase{"ItsOwnRetraction",
                   {{"filament_retract_length", "0.8"}, {"retract_length", "2"}},
                   "retract_length",
                   0.8},
        NumberCase{"ItsOwnZero",
                   {{"filament_retract_lift", "0"}, {"retract_lift", "0.4"}},
                   "retract_lift",
                   0},
        NumberCase{"Nil",
                   {{"filament_retract_length", "nil"}, {"retract_length", "3"}},
                   "retract_length",
                   3},
        NumberCase{"WipesAsTheFilamentDoes", {{"filament_wipe", "1"}, {"wipe", "0"}}, "wipe", 1},
        NumberCase{"PullsBackBeforeTheWipeAsTheFilamentDoes",
                   {{"filament_retract_before_wipe", "70%"}},
                   "retract_before_wipe",
                   70},
        NumberCase{"GcodeBetweenLayersIsRetracted",
                   {{"layer_gcode", "TIMELAPSE_TAKE_FRAME"}},
                   "retract_layer_change",
                   1},
        NumberCase{"CopiesThatMayBeLeftOutAreRetracted",
                   {{"gcode_label_objects", "octoprint"}},
                   "retract_layer_change",
                   1},
        NumberCase{"CommentsBetweenLayersAreNot",
                   {{"before_layer_gcode", ";BEFORE_LAYER_CHANGE\nG92 E0.0\n;[layer_z]\n"}},
                   "retract_layer_change",
                   0},
        NumberCase{"DeretractsAsItRetracts", {{"retract_speed", "35"}}, "deretract_speed", 35},
        NumberCase{"DeretractsAsTheFilamentRetracts",
                   {{"filament_retract_speed", "20"}},
                   "deretract_speed",
                   20},
        NumberCase{
            "PrintLimit", {{"max_volumetric_speed", "8"}}, "filament_max_volumetric_speed", 8},
        NumberCase{"LowerPrintLimit",
                   {{"max_volumetric_speed", "8"}, {"filament_max_volumetric_speed", "11"}},
                   "filament_max_volumetric_speed",
                   8},
        NumberCase{"LowerFilamentLimit",
                   {{"max_volumetric_speed", "8"}, {"filament_max_volumetric_speed", "5"}},
                   "filament_max_volumetric_speed",
                   5},
        NumberCase{"NoLimit", {}, "filament_max_volumetric_speed", 0},
        NumberCase{"CoarserResolution", {{"resolution", "0.05"}}, "outline_resolution", 0.05},
        NumberCase{"FinerResolution", {{"resolution", "0.001"}}, "outline_resolution", 0.005}),
    NameOf);

TEST(Derive, AVaseHasNoZContouring) {
  SettingValues draft = DraftOf({{"spiral_vase", "1"}, {"zaa_enabled", "1"}});
  ASSERT_TRUE(Derived(draft).ok());
  EXPECT_EQ(draft.Number("zaa_enabled"), 0);
}

TEST(Derive, ZContouringReachesMotionAndPrintsOuterWallsFirst) {
  const auto region_of = [](std::string on) {
    const std::vector<Setting> given = {
        {"zaa_enabled", std::move(on), Source::kRequest},
        {"zaa_min_z", "0.06", Source::kRequest},
        {"zaa_dont_alternate_fill_direction", "1", Source::kRequest},
        {"inner_outer_inner", "1", Source::kRequest}};
    const auto resolved = Resolve(given, Process::kFdm);
    EXPECT_TRUE(resolved.ok()) << resolved.status();
    return resolved.ok() ? FdmOf(resolved->settings).region : RegionRow();
  };
  const RegionRow level = region_of("0"), contoured = region_of("1");
  EXPECT_EQ(level.motion.contour_least_nm, 0);
  EXPECT_FALSE(level.infill.same_direction);
  EXPECT_TRUE(level.order.inner_outer_inner);
  EXPECT_EQ(contoured.motion.contour_least_nm, 60'000);
  EXPECT_TRUE(contoured.infill.same_direction);
  EXPECT_TRUE(contoured.order.external_perimeters_first);
  EXPECT_FALSE(contoured.order.inner_outer_inner);
}

TEST(Derive, LeavesAFirstLayerSpeedInPercent) {
  SettingValues draft = DraftOf({{"first_layer_speed", "40%"}});
  ASSERT_TRUE(Derived(draft).ok());
  EXPECT_EQ(*draft.At("first_layer_speed").value, (Value{.number = 40, .percent = true}));
}

struct GcodeCase {
  std::string name;
  std::string machine, filament;
  std::string want_end;
};

// The filament's G-code is the first after the layers. Before the layers, the two settings remain
// separate.
TEST(Derive, JoinsTheGcodesOfTheEnd) {
  const std::vector<GcodeCase> cases = {
      {"Both", "M", "F", "F\nM"},   {"BreaksThatAreThere", "M\n", "F\n", "F\nM\n"},
      {"NoFilament", "M", "", "M"}, {"NoMachine", "", "F", "F"},
      {"None", "", "", ""},
  };
  for (const GcodeCase& c : cases) {
    SettingValues draft(Process::kFdm);
    for (const char* key : {"start_gcode", "end_gcode"}) draft.At(key).value->text = c.machine;
    for (const char* key : {"start_filament_gcode", "end_filament_gcode"})
      draft.At(key).value->text = c.filament;
    ASSERT_TRUE(Derived(draft).ok()) << c.name;
    EXPECT_EQ(draft.At("start_gcode").value->text, c.machine) << c.name;
    EXPECT_EQ(draft.At("end_gcode").value->text, c.want_end) << c.name;
  }
}

TEST(Derive, GcodesMustFitTogether) {
  SettingValues draft(Process::kFdm);
  const std::string most(limits::kMaxSettingBytes - 20, 'x');
  draft.At("end_gcode").value->text = most;
  EXPECT_TRUE(Derived(draft).ok());
  draft = SettingValues(Process::kFdm);
  draft.At("end_gcode").value->text = most;
  draft.At("end_filament_gcode").value->text = most;
  const absl::Status status = Derived(draft);
  EXPECT_EQ(DetailOf(status).reason, Reason::kRequestTooLarge) << status;
}

struct RefusalCase {
  std::string name;
  Pairs given;
  std::string blamed;
  std::string value;
};

TEST(Derive, RefusesWhatPercentagesComeTo) {
  const std::vector<RefusalCase> cases = {
      {"TooLow", {{"first_layer_height", "1%"}}, "first_layer_height", "1%"},
      {"TooHigh", {{"first_layer_height", "5000%"}}, "first_layer_height", "5000%"},
      {"TooFast", {{"external_perimeter_speed", "100000%"}}, "external_perimeter_speed", "100000%"},
      // The two settings are now out of range; the error names the one that the user gave.
      {"GivenBeforeStandard",
       {{"infill_overlap", "2000%"}, {"perimeter_extrusion_width", "4900%"}},
       "infill_overlap",
       "2000%"},
  };
  for (const RefusalCase& c : cases) {
    SettingValues draft = DraftOf(c.given);
    const absl::Status status = Derived(draft);
    const ErrorDetail detail = DetailOf(status);
    EXPECT_EQ(detail.reason, Reason::kSettingOutOfRange) << c.name << status;
    EXPECT_EQ(detail.metadata.at("setting"), c.blamed) << c.name;
    EXPECT_EQ(detail.metadata.at("value"), c.value) << c.name;
  }
}

}  // namespace
}  // namespace slicefarm::config::fdm::derive_test
