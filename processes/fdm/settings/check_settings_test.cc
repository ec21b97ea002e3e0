#include "processes/fdm/settings/check_settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "common/base/error.h"
#include "processes/fdm/settings/derive.h"
#include "processes/fdm/settings/draft_of_test.h"

namespace slicefarm::config::fdm::check_settings_test {
namespace {

using Metadata = std::map<std::string, std::string>;

absl::Status Check(const Pairs& given) {
  SettingValues draft = DraftOf(given);
  ResolvedSettings result;
  const absl::Status derived = Derive(draft, result);
  return derived.ok() ? CheckSettings(draft) : derived;
}

struct CheckCase {
  std::string name;
  Pairs good, bad;
  Metadata want;      ///< metadata of the error
  std::string other;  ///< the other setting that the message names
};
class Checked : public testing::TestWithParam<CheckCase> {};

TEST_P(Checked, UpToItsBound) {
  const CheckCase& c = GetParam();
  EXPECT_EQ(Check(c.good), absl::OkStatus());
  const absl::Status status = Check(c.bad);
  const ErrorDetail detail = DetailOf(status);
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument) << status;
  EXPECT_EQ(detail.reason, Reason::kSettingOutOfRange) << status;
  EXPECT_EQ(Metadata(detail.metadata.begin(), detail.metadata.end()), c.want);
  EXPECT_THAT(status.message(), testing::HasSubstr(c.want.at("setting")));
  EXPECT_THAT(status.message(), testing::HasSubstr(c.other));
}

INSTANTIATE_TEST_SUITE_P(
    CheckSettings, Checked,
    testing::Values(
        CheckCase{"LayersNoHigherThanTheNozzle",
                  {{"layer_height", "0.4"}, {"perimeters", "2"}},
                  {{"layer_height", "0.400001"}},
                  {{"setting", "layer_height"}, {"value", "0.400001"}, {"max", "0.4"}},
                  "nozzle_diameter"},
        CheckCase{"FirstLayerNoHigherThanTheNozzle",
                  {{"first_layer_height", "0.4"}},
                  {{"first_layer_height", "140%"}},
                  {{"setting", "first_layer_height"}, {"value", "0.42"}, {"max", "0.4"}},
                  "nozzle_diameter"},
        CheckCase{"BeadsAtLeastAsWideAsHigh",
                  {{"perimeter_extrusion_width", "0.3"}},
                  {{"perimeter_extrusion_width", "0.29"}},
                  {{"setting", "perimeter_extrusion_width"}, {"value", "0.29"}, {"min", "0.3"}},
                  "layer_height"},
        CheckCase{"BeadsNarrowerThanThreeNozzles",
                  {{"solid_infill_extrusion_width", "1.199999"}},
                  {{"solid_infill_extrusion_width", "1.2"}},
                  {{"setting", "solid_infill_extrusion_width"}, {"value", "1.2"}, {"max", "1.2"}},
                  "nozzle_diameter"},
        CheckCase{"TopsToo",
                  {{"top_infill_extrusion_width", "0.3"}},
                  {{"top_infill_extrusion_width", "50%"}},
                  {{"setting", "top_infill_extrusion_width"}, {"value", "0.15"}, {"min", "0.3"}},
                  "layer_height"},
        CheckCase{"WidthsFromTheGeneralOne",
                  {{"extrusion_width", "0.3"}},
                  {{"extrusion_width", "0.2"}},
                  {{"setting", "perimeter_extrusion_width"}, {"value", "0.2"}, {"min", "0.3"}},
                  "layer_height"},
        CheckCase{"TheFirstLayersByItsOwnHeight",
                  {{"first_layer_extrusion_width", "0.35"}},
                  {{"first_layer_extrusion_width", "0.34"}},
                  {{"setting", "first_layer_extrusion_width"}, {"value", "0.34"}, {"min", "0.35"}},
                  "first_layer_height"},
        CheckCase{"NoShieldAroundCompleteObjects",
                  {{"complete_objects", "1"}, {"skirts", "1"}},
                  {{"complete_objects", "1"}, {"skirts", "1"}, {"draft_shield", "enabled"}},
                  {{"setting", "draft_shield"}, {"value", "enabled"}},
                  "complete_objects"},
        CheckCase{"NoHighSkirtAroundCompleteObjects",
                  {{"complete_objects", "1"}, {"skirts", "1"}, {"skirt_height", "1"}},
                  {{"complete_objects", "1"}, {"skirts", "1"}, {"skirt_height", "2"}},
                  {{"setting", "skirt_height"}, {"value", "2"}},
                  "complete_objects"},
        CheckCase{
            "LinesOfARaftByItsHeight",
            {{"support_material_extrusion_width", "0.3"},
             {"nozzle_diameter", "0.8"},
             {"raft_layers", "1"}},
            {{"support_material_extrusion_width", "0.29"},
             {"nozzle_diameter", "0.8"},
             {"layer_height", "0.1"},
             {"raft_layers", "1"}},
            {{"setting", "support_material_extrusion_width"}, {"value", "0.29"}, {"min", "0.3"}},
            "raft"},
        CheckCase{"AdaptiveLayersHaveRoom",
                  {{"adaptive_layer_height", "0"},
                   {"min_layer_height", "0.25"},
                   {"max_layer_height", "0.2"}},
                  {{"adaptive_layer_height", "1"},
                   {"min_layer_height", "0.25"},
                   {"max_layer_height", "0.2"}},
                  {{"setting", "max_layer_height"}, {"value", "0.2"}, {"min", "0.25"}},
                  "min_layer_height"},
        CheckCase{"RestartsTakeNothingBack",
                  {{"retract_length", "1"}, {"retract_restart_extra", "-1"}},
                  {{"retract_length", "1"}, {"retract_restart_extra", "-1.01"}},
                  {{"setting", "retract_restart_extra"}, {"value", "-1.01"}},
                  "retract_length"},
        CheckCase{"RetractionsTakeASpeed",
                  {{"retract_speed", "0"}, {"retract_length", "0"}},
                  {{"retract_speed", "0"}, {"retract_length", "1"}},
                  {{"setting", "retract_speed"}, {"value", "0"}},
                  "retract_length"},
        CheckCase{"GapsFromNarrowToWide",
                  {{"gap_fill_min_width", "0.5"}, {"gap_fill_max_width", "0.5"}},
                  {{"gap_fill_min_width", "0.6"}, {"gap_fill_max_width", "0.5"}},
                  {{"setting", "gap_fill_min_width"}, {"value", "0.6"}, {"max", "0.5"}},
                  "gap_fill_max_width"}),
    [](const auto& info) { return info.param.name; });

TEST(CheckSettings, TakesTheStandards) { EXPECT_EQ(Check({}), absl::OkStatus()); }

}  // namespace
}  // namespace slicefarm::config::fdm::check_settings_test
