#include "common/macro/setting_types.h"

#include <map>

#include "common/base/text.h"

namespace slicefarm::macro {
namespace {

// Keys of PrusaSlicer's settings by type, separated by spaces.
constexpr std::string_view kChoice =
    "arc_fitting bottom_fill_pattern brim_type draft_shield ensure_vertical_shell_thickness "
    "fill_pattern fuzzy_skin gcode_flavor gcode_label_objects host_type ironing_type "
    "machine_limits_usage perimeter_generator printer_technology printhost_authorization_type "
    "scarf_seam_placement seam_position slicing_mode support_material_interface_pattern "
    "support_material_pattern support_material_style thumbnails_format top_fill_pattern "
    "top_one_perimeter_type";

constexpr std::string_view kChoices = "cooling_slowdown_logic";

constexpr std::string_view kFlag =
    "autoemit_temperature_commands automatic_extrusion_widths automatic_infill_combination "
    "avoid_crossing_curled_overhangs avoid_crossing_perimeters binary_gcode complete_objects "
    "cooling_filter_enabled dont_support_bridges enable_dynamic_overhang_speeds "
    "enable_wrapping_detection external_perimeters_first extra_perimeters "
    "extra_perimeters_on_overhangs farthest_point_timelapse gap_fill_enabled gcode_comments "
    "high_current_on_filament_swap infill_first infill_only_where_needed interface_shells "
    "interlocking_beam ironing only_one_perimeter_first_layer "
    "only_retract_when_crossing_perimeters ooze_prevention overhangs prefer_clockwise_movements "
    "printhost_ssl_ignore_revoke remaining_times scarf_seam_entire_loop "
    "scarf_seam_on_inner_perimeters scarf_seam_only_on_smooth silent_mode "
    "single_extruder_multi_material single_extruder_multi_material_priming spiral_vase "
    "staggered_inner_seams support_material support_material_auto "
    "support_material_buildplate_only support_material_interface_contact_loops "
    "support_material_synchronize_layers support_material_with_sheath thick_bridges thin_walls "
    "use_firmware_retraction use_relative_e_distances use_volumetric_e variable_layer_height "
    "wipe_into_infill wipe_into_objects wipe_tower wipe_tower_no_sparse_layers "
    "wiping_volumes_use_custom_matrix";

constexpr std::string_view kFlags =
    "cooling enable_dynamic_fan_speeds fan_always_on filament_abrasive filament_multitool_ramming "
    "filament_retract_layer_change filament_soluble filament_travel_lift_before_obstacle "
    "filament_travel_ramping_lift filament_wipe nozzle_high_flow retract_layer_change "
    "travel_lift_before_obstacle travel_ramping_lift wipe";

constexpr std::string_view kNumber =
    "bottom_solid_min_thickness bridge_acceleration bridge_angle bridge_flow_ratio bridge_speed "
    "brim_separation brim_width cooling_tube_length cooling_tube_retraction default_acceleration "
    "duplicate_distance elefant_foot_compensation external_perimeter_acceleration "
    "extra_loading_move extruder_clearance_height extruder_clearance_radius fill_angle "
    "first_layer_acceleration first_layer_acceleration_over_raft fuzzy_skin_point_dist "
    "fuzzy_skin_thickness gap_fill_speed gcode_resolution infill_acceleration infill_speed "
    "interlocking_beam_width interlocking_orientation ironing_spacing ironing_speed layer_height "
    "max_print_height max_print_speed max_volumetric_extrusion_rate_slope_negative "
    "max_volumetric_extrusion_rate_slope_positive max_volumetric_speed min_skirt_length "
    "mmu_segmented_region_interlocking_depth mmu_segmented_region_max_width multimaterial_purging "
    "parking_pos_retraction perimeter_acceleration perimeter_speed raft_contact_distance "
    "raft_expansion raft_first_layer_expansion resolution scarf_seam_length "
    "scarf_seam_max_segment_length seam_preferred_direction seam_preferred_direction_jitter "
    "skirt_distance slice_closing_radius solid_infill_acceleration solid_infill_below_area "
    "solid_min_thickness support_material_angle support_material_bottom_contact_distance "
    "support_material_closing_radius support_material_contact_distance "
    "support_material_interface_spacing support_material_spacing support_material_speed "
    "support_tree_angle support_tree_angle_slow support_tree_branch_diameter "
    "support_tree_branch_diameter_angle support_tree_branch_diameter_double_wall "
    "support_tree_branch_distance support_tree_tip_diameter top_solid_infill_acceleration "
    "top_solid_infill_flow_ratio top_solid_min_thickness travel_acceleration "
    "travel_short_distance_acceleration travel_speed "
    "travel_speed_z wall_transition_angle wipe_tower_acceleration wipe_tower_bridging "
    "wipe_tower_brim_width wipe_tower_cone_angle wipe_tower_width xy_size_compensation z_offset";

constexpr std::string_view kNumberOrPercent =
    "automatic_infill_combination_max_layer_height avoid_crossing_perimeters_max_detour "
    "external_perimeter_extrusion_width external_perimeter_speed extrusion_width "
    "first_layer_extrusion_width first_layer_height first_layer_infill_speed first_layer_speed "
    "first_layer_speed_over_raft infill_anchor infill_anchor_max infill_extrusion_width "
    "infill_overlap min_bead_width min_feature_size over_bridge_speed overhang_speed_0 "
    "overhang_speed_1 overhang_speed_2 overhang_speed_3 perimeter_extrusion_width "
    "seam_gap_distance small_perimeter_speed solid_infill_extrusion_width solid_infill_speed "
    "support_material_extrusion_width support_material_interface_speed "
    "support_material_xy_spacing top_infill_extrusion_width top_solid_infill_speed "
    "wall_transition_filter_deviation wall_transition_length";

constexpr std::string_view kNumbers =
    "colorprint_heights cooling_perimeter_transition_distance deretract_speed "
    "extrusion_multiplier filament_cooling_final_speed filament_cooling_initial_speed "
    "filament_cost filament_density filament_deretract_speed filament_diameter "
    "filament_infill_max_crossing_speed filament_infill_max_speed filament_load_time "
    "filament_loading_speed filament_loading_speed_start filament_max_volumetric_speed "
    "filament_minimal_purge_on_wipe_tower filament_multitool_ramming_flow "
    "filament_multitool_ramming_volume filament_retract_before_travel filament_retract_length "
    "filament_retract_length_toolchange filament_retract_lift filament_retract_lift_above "
    "filament_retract_lift_below filament_retract_restart_extra "
    "filament_retract_restart_extra_toolchange filament_retract_speed filament_spool_weight "
    "filament_stamping_distance filament_stamping_loading_speed filament_toolchange_delay "
    "filament_travel_max_lift filament_travel_slope filament_unload_time filament_unloading_speed "
    "filament_unloading_speed_start machine_max_acceleration_e machine_max_acceleration_extruding "
    "machine_max_acceleration_retracting machine_max_acceleration_travel "
    "machine_max_acceleration_x machine_max_acceleration_y machine_max_acceleration_z "
    "machine_max_feedrate_e machine_max_feedrate_x machine_max_feedrate_y machine_max_feedrate_z "
    "machine_max_jerk_e machine_max_jerk_x machine_max_jerk_y machine_max_jerk_z "
    "machine_max_junction_deviation machine_min_extruding_rate machine_min_travel_rate "
    "max_layer_height min_layer_height min_print_speed nozzle_diameter retract_before_travel "
    "retract_length retract_length_toolchange retract_lift retract_lift_above retract_lift_below "
    "retract_restart_extra retract_restart_extra_toolchange retract_speed travel_max_lift "
    "travel_slope wiping_volumes_matrix";

constexpr std::string_view kPercent =
    "fill_density ironing_flowrate raft_first_layer_density scarf_seam_start_height "
    "support_tree_top_rate wipe_tower_extra_flow wipe_tower_extra_spacing";

constexpr std::string_view kPercents =
    "filament_purge_multiplier filament_retract_before_wipe filament_shrinkage_compensation_xy "
    "filament_shrinkage_compensation_z retract_before_wipe";

constexpr std::string_view kPoints = "bed_shape extruder_offset";

constexpr std::string_view kText =
    "bed_custom_model bed_custom_texture before_layer_gcode between_objects_gcode "
    "color_change_gcode compatible_printers_condition compatible_prints_condition "
    "custom_parameters_print custom_parameters_printer default_print_profile end_gcode "
    "extrusion_axis filament_vendor inherits layer_gcode notes output_filename_format "
    "pause_print_gcode physical_printer_settings_id preset_name print_host print_settings_id "
    "printer_model printer_notes printer_settings_id printer_variant printer_vendor "
    "printhost_apikey printhost_cafile printhost_password printhost_port printhost_user "
    "profile_vendor profile_version start_gcode template_custom_gcode thumbnails toolchange_gcode";

constexpr std::string_view kTexts =
    "compatible_printers compatible_printers_condition_cummulative compatible_prints "
    "compatible_prints_condition_cummulative custom_parameters_filament default_filament_profile "
    "end_filament_gcode extruder_colour filament_colour filament_notes "
    "filament_ramming_parameters filament_settings_id filament_type gcode_substitutions "
    "inherits_cummulative post_process preset_names start_filament_gcode";

constexpr std::string_view kWhole =
    "bed_temperature_extruder bottom_solid_layers extruder infill_every_layers infill_extruder "
    "interlocking_beam_layer_count interlocking_boundary_avoidance interlocking_depth "
    "perimeter_extruder perimeters raft_layers skirt_height skirts solid_infill_every_layers "
    "solid_infill_extruder solid_layers standby_temperature_delta "
    "support_material_bottom_interface_layers support_material_enforce_layers "
    "support_material_extruder support_material_interface_extruder "
    "support_material_interface_layers support_material_threshold top_solid_layers "
    "timelapse_type wall_distribution_count wipe_tower_extruder wrapping_detection_layers";

constexpr std::string_view kWholes =
    "idle_temperature "
    "bed_temperature bridge_fan_speed chamber_minimal_temperature chamber_temperature "
    "disable_fan_first_layers fan_below_layer_time filament_cooling_moves "
    "first_layer_bed_temperature first_layer_temperature full_fan_speed_layer max_fan_speed "
    "min_fan_speed overhang_fan_speed_0 overhang_fan_speed_1 overhang_fan_speed_2 "
    "overhang_fan_speed_3 slowdown_below_layer_time temperature";

using Of = SettingType::Of;

struct Group {
  std::string_view keys;
  SettingType type;
};
constexpr Group kGroups[] = {{kChoice, {Of::kChoice, false}},
                             {kChoices, {Of::kChoice, true}},
                             {kFlag, {Of::kFlag, false}},
                             {kFlags, {Of::kFlag, true}},
                             {kNumber, {Of::kNumber, false}},
                             {kNumbers, {Of::kNumber, true}},
                             {kNumberOrPercent, {Of::kNumberOrPercent, false}},
                             {kPercent, {Of::kPercent, false}},
                             {kPercents, {Of::kPercent, true}},
                             {kPoints, {Of::kPoint, true}},
                             {kText, {Of::kText, false}},
                             {kTexts, {Of::kText, true}},
                             {kWhole, {Of::kWhole, false}},
                             {kWholes, {Of::kWhole, true}}};

using Types = std::map<std::string_view, SettingType>;

Types MakeTypes() {
  Types types;
  for (const Group& group : kGroups)
    for (const std::string_view key : Split(group.keys, " ")) types[key] = group.type;
  return types;
}

}  // namespace

std::optional<SettingType> TypeOfSetting(std::string_view key) {
  static const Types& types = *new Types(MakeTypes());
  const auto found = types.find(key);
  if (found == types.end()) return std::nullopt;
  return found->second;
}

}  // namespace slicefarm::macro
