#include "common/config/projects/orca_settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "common/config/table/known_keys.h"
#include "common/config/table/orca_table.h"
#include "common/config/table/settings_table.h"

namespace slicefarm::config::orca_settings_test {
namespace {

using testing::IsEmpty;

struct Case {
  std::string name;
  std::vector<Setting> from;
  std::vector<std::string> to;  ///< expected settings, "key = value"
  std::vector<std::string> unknown = {};
};

std::vector<std::string> Lines(const std::vector<Setting>& settings) {
  std::vector<std::string> lines;
  for (const Setting& setting : settings) lines.push_back(setting.key + " = " + setting.value);
  return lines;
}

TEST(FromOrca, GivesNamesAndValuesOfPrusaSlicer) {
  const std::vector<Case> cases = {
      {"Nothing", {}, {}},
      {"SameName", {{"layer_height", "0.2"}}, {"layer_height = 0.2"}},
      {"Renamed", {{"wall_loops", "3"}}, {"perimeters = 3"}},
      {"Percent", {{"sparse_infill_density", "15%"}}, {"fill_density = 15%"}},
      {"PercentWithoutSign", {{"sparse_infill_density", "15"}}, {"fill_density = 15%"}},
      {"FirstOfList", {{"nozzle_temperature", R"(["220","230"])"}}, {"temperature = 220,230"}},
      {"EmptyList",
       {{"nozzle_temperature", "[]"}},
       {},
       {"nozzle_temperature = : no exact counterpart"}},
      {"Pairs",
       {{"small_area_infill_flow_compensation", "1"},
        {"small_area_infill_flow_compensation_model", R"(["0,0", "\n0.2,0.4444", "\n10,1"])"}},
       {"small_area_infill_flow_compensation = 1",
        R"(small_area_infill_flow_compensation_model = 0,0;\n0.2,0.4444;\n10,1)"}},
      {"AWholeText",
       {{"custom_gcode_per_print_z", R"([{"z":1,"type":"pause"}])"}},
       {R"(custom_gcode_per_print_z = [{"z":1,"type":"pause"}])"}},
      {"NotAList", {{"machine_start_gcode", "[wait] G28"}}, {"start_gcode = [wait] G28"}},
      {"GcodeInList",
       {{"filament_start_gcode", R"(["G1\nM104"])"}},
       {R"(start_filament_gcode = "G1\nM104")"}},
      // An array's text is one value, even if it contains special characters.
      {"GcodesWithComments",
       {{"filament_start_gcode", R"(["; PLA\nM900 K0.02 ; pressure \"PA\"","; PETG"])"}},
       {R"(start_filament_gcode = "; PLA\nM900 K0.02 ; pressure \"PA\"";"; PETG")"}},
      {"PartOfTheNozzle", {{"min_bead_width", "85"}}, {"min_bead_width = 85%"}},
      {"Shrinkage",
       {{"filament_shrink", R"(["99.5%","100"])"}, {"filament_shrinkage_compensation_z", "100.2%"}},
       {"filament_shrinkage_compensation_xy = 0.5%,0%",
        "filament_shrinkage_compensation_z = -0.2%"}},
      {"Flushing",
       {{"filament_max_volumetric_speed", R"(["12"])"},
        {"filament_flush_volumetric_speed", R"(["0"])"},
        {"nozzle_temperature_range_high", R"(["240"])"},
        {"machine_start_gcode",
         "M620.10 F{flush_volumetric_speeds[initial_no_support_extruder]/2.4} "
         "T[flush_temperatures[0]]"}},
       {"filament_max_volumetric_speed = 12", "start_gcode = M620.10 F{12/2.4} T{240}"}},
      {"BedMesh",
       {{"machine_start_gcode", "{bed_mesh_algo}"}},
       {R"(start_gcode = {local bed_mesh_algo = "bicubic"}{bed_mesh_algo})"}},
      {"PlaceholdersByName",
       {{"machine_start_gcode",
         "M140 S[bed_temperature_initial_layer_single]\\nM109 "
         "S{nozzle_temperature_initial_layer[initial_no_support_extruder]-5}"}},
       {"start_gcode = M140 S[first_layer_bed_temperature]\\nM109 "
        "S{first_layer_temperature[initial_extruder]-5}"}},
      {"PlaceholdersByValue",
       {{"machine_start_gcode",
         R"({if curr_bed_type=="Cool Plate" && timelapse_type == 1}M1{endif}[scan_first_layer])"},
        {"curr_bed_type", "Cool Plate"},
        {"timelapse_type", "0"},
        {"scan_first_layer", R"(["1"])"}},
       {R"(start_gcode = {if "Cool Plate"=="Cool Plate" && timelapse_type == 1}M1{endif}{1})",
        "curr_bed_type = Cool Plate", "timelapse_type = 0"},
       {}},
      {"FlowOfOuterWall",
       {{"machine_end_gcode", "F{outer_wall_volumetric_speed/2.4053*60}"},
        {"layer_height", "0.2"},
        {"outer_wall_line_width", "0.4"},
        {"outer_wall_speed", R"(["200"])"},
        {"filament_max_volumetric_speed", R"(["12"])"}},
       {"layer_height = 0.2", "external_perimeter_extrusion_width = 0.4",
        "external_perimeter_speed = 200", "filament_max_volumetric_speed = 12",
        "end_gcode = F{12/2.4053*60}"}},
      {"EmptyGcode", {{"layer_change_gcode", ""}}, {"layer_gcode = "}},
      {"Pattern", {{"sparse_infill_pattern", "tri-hexagon"}}, {"fill_pattern = stars"}},
      {"PatternNobodyElseHas",
       {{"sparse_infill_pattern", "no_such"}},
       {},
       {"sparse_infill_pattern = no_such"}},
      {"Crosshatch", {{"sparse_infill_pattern", "crosshatch"}}, {"fill_pattern = crosshatch"}},
      {"QuarterCubic",
       {{"sparse_infill_pattern", "quartercubic"}},
       {"fill_pattern = quartercubic"}},
      {"SurfaceOfOtherName", {{"sparse_infill_pattern", "tpmsd"}}, {"fill_pattern = schwarzd"}},
      {"Thumbnails",
       {{"thumbnails", R"(["48x48/PNG","300x300"])"}, {"thumbnails_format", "QOI"}},
       {"thumbnails = 48x48/PNG,300x300", "thumbnails_format = QOI"}},
      {"OneSlopeForBoth",
       {{"max_volumetric_extrusion_rate_slope", "120"}},
       {"max_volumetric_extrusion_rate_slope_positive = 120",
        "max_volumetric_extrusion_rate_slope_negative = 120"}},
      {"ClumpingDetection",
       {{"enable_wrapping_detection", "1"},
        {"wrapping_detection_gcode", "G39 ; [layer_num]\\n"},
        {"wrapping_exclude_area", R"(["150x180","200x180","200x200","150x200"])"}},
       {"enable_wrapping_detection = 1", "wrapping_detection_gcode = G39 ; [layer_num]\\n",
        "wrapping_exclude_area = 150x180,200x180,200x200,150x200"}},
      {"MassOfTheBed",
       {{"machine_max_force_Y", "29"},
        {"machine_bed_mass_Y", "2700"},
        {"layer_change_gcode", "M201 N1 Y[curr_y_acceleration_limit]"}},
       {"machine_max_force_y = 29", "machine_bed_mass_y = 2700",
        "layer_gcode = M201 N1 Y[curr_y_acceleration_limit]"}},
      {"FlowByTheBead",
       {{"filament_adaptive_volumetric_speed", R"(["1"])"},
        {"volumetric_speed_coefficients", R"(["0 0 0 0 5 0.5","0 0 0 0 0 0"])"}},
       {"filament_adaptive_volumetric_speed = 1",
        R"(volumetric_speed_coefficients = "0 0 0 0 5 0.5";"0 0 0 0 0 0")"}},
      {"FarthestPoint",
       {{"farthest_point_timelapse", "1"},
        {"time_lapse_gcode", "M9711 Z{layer_z + (farthest_point_timelapse_enabled ? 0.0 : 0.4)}"}},
       {"farthest_point_timelapse = 1",
        "time_lapse_gcode = M9711 Z{layer_z + (farthest_point_timelapse ? 0.0 : 0.4)}"}},
      {"BetweenObjects",
       {{"printing_by_object_gcode", "G28 X"}},
       {"between_objects_gcode = G28 X"}},
      {"ShareOfANumber",
       {{"seam_slope_start_height", "0.05"}, {"layer_height", "0.2"}},
       {"layer_height = 0.2", "scarf_seam_start_height = 25%"}},
      {"ShareOfAPercentage",
       {{"seam_slope_start_height", "10%"}},
       {"scarf_seam_start_height = 10%"}},
      {"OverhangFan",
       {{"overhang_fan_speed", R"(["90"])"}, {"overhang_fan_threshold", R"(["25%"])"}},
       {"bridge_fan_speed = 90", "overhang_fan_threshold = 25%"}},
      {"WipeSpeed",
       {{"wipe_speed", "80%"}, {"wipe_distance", R"(["2"])"}},
       {"wipe_distance = 2", "wipe_speed = 80%"}},
      {"AlmostTheSame",
       {{"brim_type", "painted"}},
       {"brim_type = no_brim"},
       {"brim_type = painted"}},
      {"Clockwise", {{"wall_direction", "cw"}}, {"prefer_clockwise_movements = 1"}},
      {"SlopeLift",
       {{"z_hop", R"(["0.4"])"},
        {"z_hop_types", R"(["Slope Lift"])"},
        {"travel_slope", R"(["5"])"}},
       {"retract_lift = 0.4", "travel_ramping_lift = 1", "travel_slope = 5",
        "travel_max_lift = 0.4"}},
      {"FilamentsSlopeLift",
       {{"z_hop", "0.4"},
        {"z_hop_types", "Normal Lift"},
        {"filament_z_hop", "0.6"},
        {"filament_z_hop_types", "Slope Lift"}},
       {"filament_retract_lift = 0.6", "retract_lift = 0.4", "travel_ramping_lift = 1",
        "travel_slope = 3", "travel_max_lift = 0.4", "filament_travel_max_lift = 0.6"}},
      {"NormalLift", {{"z_hop_types", "Normal Lift"}}, {}},
      {"AutoLift",
       {{"z_hop_types", "Auto Lift"}, {"z_hop", "0.4"}},
       {"retract_lift = 0.4", "travel_lift_before_obstacle = 1", "travel_ramping_lift = 1",
        "travel_slope = 3", "travel_max_lift = 0.4"}},
      {"SpiralLift",
       {{"z_hop_types", "Spiral Lift"}, {"z_hop", "0.4"}},
       {"retract_lift = 0.4", "travel_max_lift = 0.4", "travel_ramping_lift = 1",
        "travel_slope = 3", "travel_spiral_lift = 1"}},
      {"AutoBrim", {{"brim_type", "auto_brim"}}, {"brim_type = auto_brim"}},
      {"Brim", {{"brim_type", "outer_only"}}, {"brim_type = outer_only"}},
      {"Ears",
       {{"brim_type", "brim_ears"}, {"brim_ears_max_angle", "90"}},
       {"brim_type = brim_ears", "brim_ears_max_angle = 90"}},
      {"Area",
       {{"printable_area", R"(["0x0","256x0","256x256","0x256"])"}},
       {"bed_shape = 0x0,256x0,256x256,0x256"}},
      {"Flag",
       {{"independent_support_layer_height", "1"}},
       {"support_material_synchronize_layers = 0"}},
      {"WidthInMm", {{"line_width", "0.42"}}, {"extrusion_width = 0.42"}},
      {"WidthInPercent",
       {{"line_width", "105%"}, {"nozzle_diameter", R"(["0.4"])"}},
       {"extrusion_width = 0.42", "nozzle_diameter = 0.4"}},
      {"WidthOfNothing", {{"line_width", "105%"}}, {}, {"line_width = 105%: no exact counterpart"}},
      {"Acceleration",
       {{"inner_wall_acceleration", "50%"}, {"default_acceleration", "5000"}},
       {"default_acceleration = 5000", "perimeter_acceleration = 2500"}},
      {"TwoOfOne", {{"ironing_type", "topmost"}}, {"ironing = 1", "ironing_type = topmost"}},
      {"OneOfTwo", {{"ironing_type", "no ironing"}}, {"ironing = 0"}},
      {"StyleOfSupports",
       {{"support_style", "snug"}, {"support_type", "normal(manual)"}},
       {"support_material_auto = 0", "support_material_style = snug"}},
      {"UsualStyle",
       {{"support_style", "default"}, {"support_type", "tree(auto)"}},
       {"support_material_auto = 1", "support_material_style = organic"}},
      {"BedInPrinter",
       {{"curr_bed_type", "Textured PEI Plate"},
        {"hot_plate_temp", R"(["50"])"},
        {"textured_plate_temp", R"(["65"])"},
        {"textured_plate_temp_initial_layer", R"(["70"])"}},
       {"bed_temperature = 65", "first_layer_bed_temperature = 70",
        "curr_bed_type = Textured PEI Plate"}},
      {"UnknownBedInCode",
       {{"machine_start_gcode", R"({if curr_bed_type=="Cool Plate"}M1{endif})"}},
       {R"(start_gcode = {if "High Temp Plate"=="Cool Plate"}M1{endif})"}},
      {"IdOfFilament", {{"filament_ids", R"(["GFA00"])"}}, {"filament_id = GFA00"}},
      {"UsualBed",
       {{"hot_plate_temp", R"(["50"])"}, {"cool_plate_temp", R"(["35"])"}},
       {"bed_temperature = 50"}},
      {"Unknown",
       {{"z_foo", "1"}, {"a_bar", "2"}},
       {},
       {"z_foo: no setting of OrcaSlicer, which ignores it (as of February 2026)",
        "a_bar: no setting of OrcaSlicer, which ignores it (as of February 2026)"}},
      {"WeightyFirst",
       {{"z_foo", "1"}, {"post_process", "a.py"}, {"skirt_type", "combined"}},
       {"skirt_type = combined"},
       {"post_process = a.py",
        "z_foo: no setting of OrcaSlicer, which ignores it (as of February 2026)"}},
      // On a machine with a head wider than the nozzle's radius, the head would hit copies.
      {"WidestClearance",
       {{"extruder_clearance_radius", "57"}, {"extruder_clearance_max_radius", "68"}},
       {"extruder_clearance_radius = 68"}},
      {"FlowCompensationAsOneText",
       {{"small_area_infill_flow_compensation_model", R"(0,0;"\n0.2,0.4444";"\n10,1")"}},
       {R"(small_area_infill_flow_compensation_model = 0,0;\n0.2,0.4444;\n10,1)"}},
      {"NoLimitOfAnAxis",
       {{"machine_max_acceleration_e", R"(["0", "0"])"}, {"machine_max_speed_x", R"(["0"])"}},
       {"machine_limits_usage = emit_to_gcode"}},
      {"FanBesideTheBed",
       {{"auxiliary_fan", "1"},
        {"additional_cooling_fan_speed", R"(["70"])"},
        {"close_fan_the_first_x_layers", R"(["2"])"},
        {"layer_change_gcode", "M117"}},
       {"disable_fan_first_layers = 2", "layer_gcode = {if layer_num==2}M106 P2 S178\\n{endif}M117",
        "end_gcode = M106 P2 S0\\n"}},
      {"NoFanBesideTheBed",
       {{"auxiliary_fan", "0"}, {"additional_cooling_fan_speed", R"(["70"])"}},
       {}},
      {"CoolingOfAChamber",
       {{"machine_start_gcode", "[chamber_cooling_mode]"},
        {"temperature_vitrification", R"(["60"])"}},
       {"start_gcode = {1}"}},
      {"SwitchThatHasNoEffect",
       {{"layer_change_gcode", "{if spiral_mode}M117 vase{endif}"}},
       {"layer_gcode = {if spiral_vase}M117 vase{endif}"}},
      {"Jerk",
       {{"default_jerk", "9"}, {"outer_wall_jerk", "7"}, {"travel_jerk", "12"}},
       {"default_jerk = 9", "external_perimeter_jerk = 7", "travel_jerk = 12"}},
      {"JerkOfFirstTravels",
       {{"travel_jerk", "12"}, {"initial_layer_travel_jerk", "50%"}},
       {"travel_jerk = 12", "first_layer_travel_jerk = 6"}},
      {"Walls",
       {{"precise_outer_wall", "1"},
        {"overhang_reverse", "1"},
        {"overhang_reverse_threshold", "50%"},
        {"filter_out_gap_fill", "0.5"},
        {"gap_fill_target", "topbottom"},
        {"min_width_top_surface", "300%"}},
       {"precise_outer_wall = 1", "overhang_reverse = 1", "overhang_reverse_threshold = 50%",
        "gap_fill_min_length = 0.5", "gap_fill_target = topbottom",
        "min_width_top_surface = 300%"}},
      {"FirstLayersBeads",
       {{"initial_layer_min_bead_width", "100"}},
       {"first_layer_min_bead_width = 100%"}},
      {"Ironing", {{"ironing_pattern", "zig-zag"}}, {"ironing_pattern = rectilinear"}},
      {"IroningAngle",
       {{"ironing_angle", "30"}, {"ironing_angle_fixed", "1"}, {"ironing_expansion", "0.5"}},
       {"ironing_angle = 30", "ironing_angle_fixed = 1", "ironing_expansion = 0.5"}},
      {"ZContouring",
       {{"zaa_enabled", "1"},
        {"zaa_min_z", "0.06"},
        {"zaa_minimize_perimeter_height", "30"},
        {"zaa_dont_alternate_fill_direction", "1"}},
       {"zaa_enabled = 1", "zaa_min_z = 0.06", "zaa_minimize_perimeter_height = 30",
        "zaa_dont_alternate_fill_direction = 1"}},
      {"IroningOfSupports",
       {{"support_ironing", "1"},
        {"support_ironing_flow", "12%"},
        {"support_ironing_pattern", "concentric"},
        {"support_ironing_spacing", "0.15"}},
       {"support_ironing = 1", "support_ironing_flow = 12%", "support_ironing_pattern = concentric",
        "support_ironing_spacing = 0.15"}},
      {"Overlap", {{"top_bottom_infill_wall_overlap", "15"}}, {"top_bottom_infill_overlap = 15%"}},
      {"Supports",
       {{"support_expansion", "1"},
        {"support_bottom_interface_spacing", "0.3"},
        {"support_threshold_overlap", "50%"}},
       {"support_material_expansion = 1", "support_material_bottom_interface_spacing = 0.3",
        "support_material_threshold_overlap = 50%"}},
      {"FansAndWipes",
       {{"fan_speedup_time", "0.5"},
        {"fan_speedup_overhangs", "0"},
        {"enable_overhang_bridge_fan", R"(["0"])"},
        {"dont_slow_down_outer_wall", R"(["1"])"},
        {"wipe_on_loops", "1"},
        {"wipe_before_external_loop", "1"}},
       {"fan_speedup_time = 0.5", "fan_speedup_overhangs = 0", "enable_bridge_fan = 0",
        "dont_slow_down_outer_wall = 1", "wipe_on_loops = 1", "wipe_before_external_loop = 1"}},
      {"NamesOfOlderVersions",
       {{"ironing_direction", "30"}, {"support_material_angle", "20"}},
       {"ironing_angle = 30", "support_material_angle = 20"}},
      {"PlaceOnTheBed", {{"best_object_pos", "0.7x0.5"}}, {"best_object_pos = 0.7x0.5"}},
      {"PlaceOnTheBedOfAProject", {{"best_object_pos", "0.7,0.5"}}, {"best_object_pos = 0.7x0.5"}},
      {"BridgesWithTheFanOfTheLayer",
       {{"overhang_fan_speed", R"(["-1"])"}},
       {"bridge_fan_speed = -1"}},
      {"BridgesOfOverlappingLines", {{"bridge_density", "120%"}}, {"bridge_density = 120%"}},
      {"RaftsWidth", {{"raft_first_layer_expansion", "2"}}, {"raft_first_layer_expansion = 2"}},
      // Bambu Studio 2.3 and later: the slicer chooses the width.
      {"RaftsWidthBySlicer", {{"raft_first_layer_expansion", "-1"}}, {}},
      {"ShellsOfOrca",
       {{"ensure_vertical_shell_thickness", "ensure_all"}},
       {"ensure_vertical_shell_thickness = enabled"}},
      {"ShellsOfBambu",
       {{"ensure_vertical_shell_thickness", "partial"}},
       {"ensure_vertical_shell_thickness = partial"}},
      {"PressureAdvanceOff",
       {{"enable_pressure_advance", R"(["0"])"}, {"pressure_advance", R"(["0.04"])"}},
       {}},
      {"PressureAdvanceOn",
       {{"enable_pressure_advance", R"(["1"])"}, {"pressure_advance", R"(["0.04"])"}},
       {"pressure_advance = 0.04"}},
      {"ExcludeObject",
       {{"gcode_label_objects", "1"}, {"exclude_object", "1"}},
       {"gcode_label_objects = firmware"}},
      {"NothingExcluded",
       {{"gcode_label_objects", "1"}, {"exclude_object", "0"}},
       {"gcode_label_objects = octoprint"}},
      {"LastOfTwo", {{"wall_loops", "3"}, {"wall_loops", "4"}}, {"perimeters = 4"}},
  };
  for (const Case& c : cases) {
    OrcaUnused unused;
    EXPECT_THAT(Lines(FromOrca(c.from, &unused)), testing::UnorderedElementsAreArray(c.to))
        << c.name;
    std::ranges::move(unused.others, std::back_inserter(unused.of_print));
    EXPECT_EQ(unused.of_print, c.unknown) << c.name;
  }
}

TEST(FromOrca, OrganicTreesHaveSettingsOfTheirOwn) {
  const std::vector<Setting> trees = {
      {"tree_support_branch_angle", "40"},   {"tree_support_branch_angle_organic", "50"},
      {"tree_support_branch_diameter", "5"}, {"tree_support_branch_diameter_organic", "2"},
      {"tree_support_branch_distance", "5"}, {"tree_support_branch_distance_organic", "1"},
      {"tree_support_tip_diameter", "0.8"}};
  const std::vector<std::string> organic = {
      "support_tree_angle = 50", "support_tree_branch_diameter = 2",
      "support_tree_branch_distance = 1", "support_tree_tip_diameter = 0.8"};
  const std::vector<std::string> others = {
      "support_tree_angle = 40", "support_tree_branch_diameter = 5",
      "support_tree_branch_distance = 5", "support_tree_tip_diameter = 0.8"};
  const auto lines = [](const std::vector<Setting>& given) {
    OrcaUnused unused;
    std::vector<Setting> taken = FromOrca(given, &unused, 0);
    std::erase_if(taken, [](const Setting& s) { return s.key == "support_material_style"; });
    EXPECT_THAT(unused.of_print, IsEmpty());
    return Lines(taken);
  };
  EXPECT_EQ(lines(trees), organic);
  for (const std::string style : {"default", "organic", "snug", "tree_slim", "tree_strong"}) {
    std::vector<Setting> given = trees;
    given.push_back({"support_style", style});
    EXPECT_EQ(lines(given), style.starts_with("tree_") ? others : organic) << style;
  }
  // Settings of Bambu Studio.
  EXPECT_EQ(lines({{"tree_support_branch_angle", "40"}, {"support_style", "organic"}}),
            std::vector<std::string>{"support_tree_angle = 40"});
}

/// An object that chooses another kind of tree also gets the settings of this kind from the
/// project.
TEST(FromOrca, WhoChoosesTheTreesHasTheirSettings) {
  const std::vector<Setting> given = {{"tree_support_branch_angle", "40", Source::kProfile},
                                      {"tree_support_branch_angle_organic", "50", Source::kProfile},
                                      {"support_style", "tree_slim", Source::kProfile},
                                      {"support_style", "organic", Source::kRequest}};
  const std::vector<Setting> taken = FromOrca(given, nullptr);
  const auto angle = std::ranges::find(taken, "support_tree_angle", &Setting::key);
  ASSERT_NE(angle, taken.end());
  EXPECT_EQ(*angle, (Setting{"support_tree_angle", "50", Source::kRequest}));
}

TEST(FromOrca, KeepsWhoAsks) {
  const std::vector<Setting> from = {{"wall_loops", "3", Source::kProfile},
                                     {"layer_height", "0.1"}};
  const std::vector<Setting> settings = FromOrca(from, nullptr);
  ASSERT_FALSE(settings.empty());
  for (const Setting& setting : settings)
    EXPECT_EQ(setting.source, setting.key == "perimeters" ? Source::kProfile : Source::kRequest);
}

/// Every name in the table is a setting of PrusaSlicer or of ours; this finds misspelt names.
TEST(OrcaTable, LeadsToKnownKeys) {
  ASSERT_FALSE(OrcaRows().empty());
  const std::set<std::string_view> of_objects = {"extruder"};  // in no config.ini
  for (const OrcaRow& row : OrcaRows()) {
    const bool known = FindSetting(row.to, Process::kFdm) >= 0 || FindKnownKey(row.to) != nullptr;
    EXPECT_TRUE(known || of_objects.contains(row.to)) << row.to;
  }
}

TEST(OrcaTable, VariablesAreNoSettings) {
  ASSERT_FALSE(OrcaVariables().empty());
  ASSERT_FALSE(OrcaRows().empty());
  for (const OrcaVariable& variable : OrcaVariables()) {
    for (const OrcaRow& row : OrcaRows()) EXPECT_NE(row.from, variable.from);
  }
}

TEST(OrcaTable, ChoicesBelongToRows) {
  ASSERT_FALSE(OrcaChoices().empty());
  ASSERT_FALSE(OrcaRows().empty());
  for (const OrcaChoice& choice : OrcaChoices()) {
    const bool has_row = std::ranges::any_of(OrcaRows(), [&](const OrcaRow& row) {
      return row.to == choice.row && row.value == OrcaValue::kChoice;
    });
    EXPECT_TRUE(has_row) << choice.row;
  }
  for (const OrcaRow& row : OrcaRows()) {
    const bool has_choice = std::ranges::any_of(
        OrcaChoices(), [&](const OrcaChoice& choice) { return choice.row == row.to; });
    EXPECT_EQ(has_choice, row.value == OrcaValue::kChoice) << row.from;
  }
}

}  // namespace
}  // namespace slicefarm::config::orca_settings_test
