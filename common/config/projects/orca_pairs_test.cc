#include "common/config/projects/orca_pairs.h"

#include <gtest/gtest.h>

#include <map>

namespace slicefarm::config::orca_pairs_test {
namespace {

using Given = std::map<std::string, std::string, std::less<>>;

/// Returns `key = value` of each setting.
std::vector<std::string> Paired(const Given& given) {
  std::vector<std::string> lines;
  for (const PairedSetting& paired : PairedSettingsOf([&](std::string_view key) {
         const auto found = given.find(key);
         return found == given.end() ? std::nullopt : std::optional(found->second);
       })) {
    EXPECT_TRUE(given.contains(paired.because)) << paired.because;
    lines.push_back(std::string(paired.key) + " = " + paired.value);
  }
  return lines;
}

struct Case {
  std::string name;
  Given given;
  std::vector<std::string> settings;
};
class PairedSettings : public testing::TestWithParam<Case> {};

TEST_P(PairedSettings, DependOnTheirSwitches) {
  EXPECT_EQ(Paired(GetParam().given), GetParam().settings);
}

INSTANTIATE_TEST_SUITE_P(
    Orca, PairedSettings,
    testing::Values(
        Case{"Nothing", {}, {}},
        Case{"AdaptiveAdvance",
             {{"enable_pressure_advance", "1"},
              {"adaptive_pressure_advance", "1"},
              {"adaptive_pressure_advance_model", "0.04,4,3000\\n0.03,8,3000"}},
             {"adaptive_pressure_advance = 1",
              "adaptive_pressure_advance_model = 0.04,4,3000;0.03,8,3000"}},
        Case{"AdaptiveAdvanceWithoutAModel",
             {{"enable_pressure_advance", "1"},
              {"adaptive_pressure_advance", "1"},
              {"adaptive_pressure_advance_model", "0,0,0\\n0,0,0"}},
             {"adaptive_pressure_advance = 1", "adaptive_pressure_advance_model = "}},
        Case{"NoAdvanceAtAll",
             {{"enable_pressure_advance", "0"},
              {"adaptive_pressure_advance", "1"},
              {"adaptive_pressure_advance_model", "0.04,4,3000\\n0.03,8,3000"}},
             {}},
        Case{"FanWithoutSlowing",
             {{"slow_down_for_layer_cooling", "0"}},
             {"cooling = 1", "min_print_speed = 1000"}},
        Case{"FanWithSlowing", {{"slow_down_for_layer_cooling", "1"}}, {}},
        Case{"BottomSurfacesKeepTheirFlow",
             {{"set_other_flow_ratios", "1"},
              {"internal_solid_infill_flow_ratio", "1.25"},
              {"bottom_solid_infill_flow_ratio", "1.1"}},
             {"bottom_solid_infill_flow_ratio = 0.88", "solid_infill_flow_ratio = 1.25"}},
        Case{"IroningOfTheFilament",
             {{"filament_ironing_flow", "12%"},
              {"filament_ironing_spacing", "nil"},
              {"filament_ironing_speed", "25"}},
             {"ironing_flowrate = 12%", "ironing_speed = 25"}},
        Case{"DecelOff",
             {{"accel_to_decel_enable", "0"}, {"accel_to_decel_factor", "30%"}},
             {"accel_to_decel = 0"}},
        Case{"DecelOn",
             {{"accel_to_decel_enable", "1"}, {"accel_to_decel_factor", "30%"}},
             {"accel_to_decel = 30%"}},
        Case{"DecelStandard", {{"accel_to_decel_enable", "1"}}, {"accel_to_decel = 50%"}},
        Case{"FlowOfProcessAndFilament",
             {{"print_flow_ratio", "0.95"}, {"filament_flow_ratio", "0.98"}},
             {"extrusion_multiplier = 0.931"}},
        Case{
            "FlowOfProcessIsOne", {{"print_flow_ratio", "1"}, {"filament_flow_ratio", "0.98"}}, {}},
        Case{"OtherFlowsOff", {{"outer_wall_flow_ratio", "0.9"}}, {}},
        Case{"OtherFlowsOn",
             {{"set_other_flow_ratios", "1"}, {"outer_wall_flow_ratio", "0.9"}},
             {"external_perimeter_flow_ratio = 0.9"}},
        Case{"NoPellets", {{"pellet_flow_coefficient", "1"}}, {}},
        Case{"Pellets",
             {{"pellet_modded_printer", "1"}, {"pellet_flow_coefficient", "1"}},
             {"filament_diameter = 1.128379"}},
        Case{"NoSupportWalls",
             {{"tree_support_wall_count", "0"}},
             {"support_material_with_sheath = 0", "support_tree_branch_diameter_double_wall = 5"}},
        Case{
            "OneSupportWall",
            {{"tree_support_wall_count", "1"}},
            {"support_material_with_sheath = 1", "support_tree_branch_diameter_double_wall = 100"}},
        Case{"TwoSupportWalls",
             {{"tree_support_wall_count", "2"}},
             {"support_material_with_sheath = 1", "support_tree_branch_diameter_double_wall = 0"}},
        Case{"ColumnsIgnoreSettingsOfTrees",
             {{"support_type", "normal(auto)"},
              {"max_bridge_length", "0"},
              {"support_critical_regions_only", "1"}},
             {}},
        Case{"TreesSupportLongBridges",
             {{"support_type", "tree(auto)"}, {"max_bridge_length", "10"}},
             {"dont_support_bridges = 1", "support_material_max_bridge_length = 10"}},
        Case{"TreesSupportAllBridges",
             {{"support_type", "tree(auto)"}, {"max_bridge_length", "0"}},
             {"dont_support_bridges = 0", "support_material_max_bridge_length = 0"}},
        Case{"TreesAtCriticalRegions",
             {{"support_type", "tree(auto)"}, {"support_critical_regions_only", "1"}},
             {"support_material_critical_only = 1"}},
        Case{"OrganicTreesHaveNoBrim",
             {{"tree_support_brim_width", "4"}, {"tree_support_auto_brim", "0"}},
             {}},
        Case{"BrimOfTrees",
             {{"support_style", "tree_slim"},
              {"tree_support_brim_width", "4"},
              {"tree_support_auto_brim", "0"}},
             {"raft_first_layer_expansion = 4"}}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace slicefarm::config::orca_pairs_test
