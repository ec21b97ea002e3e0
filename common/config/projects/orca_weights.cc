#include "common/config/projects/orca_weights.h"

#include <algorithm>

#include "common/base/text.h"

namespace slicefarm::config {
namespace {

/// Setting that names scripts, which slicefarm never runs.
constexpr std::string_view kScripts = "post_process";

/// Settings of presets, hosts and windows, and settings that OrcaSlicer ignores.
constexpr std::string_view kOfProgram =
    "bbl_use_printhost bed_custom_model bed_custom_texture bed_temperature_formula "
    "calib_flowrate_topinfill_special_order compatible_printers compatible_printers_condition "
    "compatible_prints compatible_prints_condition default_bed_type default_filament_colour "
    "default_filament_profile default_nozzle_volume_type default_print_profile "
    "deretract_speed_extruder_change extruder_colour extruder_type extruder_variant_list "
    "filament_adhesiveness_category filament_dev_ams_drying_ams_limitations "
    "filament_dev_ams_drying_heat_distortion_temperature filament_dev_ams_drying_temperature "
    "filament_dev_ams_drying_time filament_dev_chamber_drying_bed_temperature "
    "filament_dev_chamber_drying_time filament_dev_drying_cooling_temperature "
    "filament_dev_drying_softening_temperature filament_extruder_compatibility "
    "filament_extruder_variant filament_notes filament_plugin_config_overrides "
    "filament_printable flashforge_serial_number gcode_add_line_number gcode_skip_config_block "
    "host_type inherits notes nozzle_flush_dataset nozzle_hrc nozzle_temperature_range_low "
    "nozzle_type physical_extruder_map plugins preferred_orientation print_extruder_id "
    "print_extruder_variant print_host print_host_webui print_plugin_config_overrides "
    "printer_agent printer_extruder_id printer_extruder_variant printer_notes "
    "printer_plugin_config_overrides printer_structure printer_technology printer_variant "
    "printhost_apikey printhost_authorization_type printhost_cafile printhost_password "
    "printhost_port printhost_ssl_ignore_revoke printhost_user required_nozzle_HRC silent_mode "
    "slicing_pipeline_plugin support_air_filtration support_chamber_temp_control "
    "support_cooling_filter support_fast_purge_mode support_multi_bed_types "
    "support_object_skip_flush upward_compatible_machine use_3mf adaptive_layer_height "
    "tree_support_adaptive_layer_height smooth_coefficient infill_rotate_step "
    "internal_bridge_support_thickness z_hop_when_prime "
    "retract_lift_when_prime tree_support_with_infill nozzle_temperature_range_high "
    "nozzle_temperature_range_low "
    "temperature_vitrification";

/// Settings for several tools or filaments; a job prints with one.
constexpr std::string_view kOfTools =
    "bottom_surface_filament_id cooling_tube_length cooling_tube_retraction delta_temperature "
    "disable_heater_after_last_use enable_change_pressure_when_wiping enable_filament_ramming "
    "enable_long_retraction_when_cut "
    "enable_mixed_color_sublayer enable_pre_heating enable_tower_interface_cooldown_during_tower "
    "enable_tower_interface_features extra_loading_move extruder_max_nozzle_count "
    "extruder_printable_area extruder_printable_height filament_change_length "
    "filament_change_length_nc filament_cooling_before_tower filament_cooling_final_speed "
    "filament_cooling_initial_speed filament_cooling_moves filament_flush_temp_fast "
    "filament_is_support filament_loading_speed filament_loading_speed_start "
    "filament_long_retractions_when_cut filament_minimal_purge_on_wipe_tower "
    "filament_multitool_ramming filament_multitool_ramming_flow "
    "filament_multitool_ramming_volume filament_pre_cooling_temperature "
    "filament_pre_cooling_temperature_nc filament_preheat_temperature_delta "
    "filament_prime_volume filament_prime_volume_nc filament_ramming_parameters "
    "filament_ramming_travel_time filament_ramming_travel_time_nc "
    "filament_ramming_volumetric_speed filament_ramming_volumetric_speed_nc "
    "filament_retract_length_nc filament_retract_length_toolchange "
    "filament_retract_restart_extra_toolchange filament_retraction_distances_when_cut "
    "filament_stamping_distance filament_stamping_loading_speed filament_toolchange_delay "
    "filament_tower_interface_pre_extrusion_dist filament_tower_interface_pre_extrusion_length "
    "filament_tower_interface_print_temp filament_tower_interface_purge_volume "
    "filament_tower_ironing_area filament_unloading_speed filament_unloading_speed_start "
    "filament_volume_maps "
    "flush_into_infill flush_into_objects flush_into_support grab_length group_algo_with_time "
    "high_current_on_filament_swap hotend_cooling_rate hotend_heating_rate idle_temperature "
    "inner_wall_filament_id interlocking_beam interlocking_beam_layer_count "
    "interlocking_beam_width interlocking_boundary_avoidance interlocking_depth "
    "interlocking_orientation internal_solid_filament_id long_retractions_when_cut "
    "long_retractions_when_ec machine_hotend_change_time machine_load_filament_time "
    "machine_prepare_compensation_time machine_tool_change_time machine_unload_filament_time "
    "manual_filament_change master_extruder_id mmu_segmented_region_interlocking_depth "
    "mmu_segmented_region_max_width nozzle_volume outer_wall_filament_id "
    "parallel_printheads_bed_exclude_areas parallel_printheads_count parking_pos_retraction "
    "preheat_steps preheat_time prime_tower_brim_chamfer prime_tower_brim_chamfer_max_width "
    "prime_tower_enable_framework prime_tower_flat_ironing "
    "prime_tower_infill_gap prime_tower_skip_points prime_volume purge_in_prime_tower "
    "ramming_line_width_ratio ramming_pressure_advance_value "
    "retraction_distances_when_cut retraction_distances_when_ec "
    "single_extruder_multi_material_priming sparse_infill_filament_id "
    "support_interface_not_for_body support_parallel_printheads tool_change_on_wipe_tower "
    "tool_change_temprature_wait "
    "toolchange_cyclic_first_layer toolchange_cyclic_order toolchange_ordering "
    "top_surface_filament_id wait_for_temp_on_wipe_tower wipe_tower_bridging "
    "wipe_tower_cone_angle wipe_tower_extra_flow wipe_tower_extra_rib_length "
    "wipe_tower_extra_spacing wipe_tower_filament wipe_tower_fillet_wall "
    "wipe_tower_max_purge_speed wipe_tower_no_sparse_layers wipe_tower_rib_width "
    "wipe_tower_sparse_layers_combination wipe_tower_type wipe_tower_wall_type "
    "wiping_volumes_extruders";

/// Settings that act through custom G-code, or only together with another setting.
constexpr std::string_view kOfOthers =
    "activate_chamber_temp_control adaptive_bed_mesh_margin bed_mesh_max bed_mesh_min "
    "bed_mesh_probe_distance emit_machine_limits_to_gcode filament_flush_temp "
    "filament_flush_volumetric_speed head_wrap_detect_zone";

/// Settings that act in Bambu Studio, but not in OrcaSlicer.
constexpr std::string_view kOfBambuStudio =
    "overhang_totally_speed override_process_overhang_speed filament_scarf_gap "
    "filament_scarf_height filament_scarf_length filament_scarf_seam_type "
    "override_filament_scarf_seam_setting";

bool Names(std::string_view keys, std::string_view key) {
  const std::vector<std::string_view> all = Split(keys, " ");
  return std::ranges::find(all, key) != all.end();
}

/// Returns true if `value`, or each of its items if it is a list, is empty.
bool IsEmpty(std::string_view value) {
  return value.find_first_not_of("[]\", \n") == std::string_view::npos;
}

}  // namespace

OrcaWeight WeightOf(std::string_view key, std::string_view value) {
  for (const std::string_view keys : {kOfProgram, kOfTools, kOfOthers})
    if (Names(keys, key)) return OrcaWeight::kNothing;
  if (key != kScripts) return OrcaWeight::kDetail;
  return IsEmpty(value) ? OrcaWeight::kNothing : OrcaWeight::kPrint;
}

std::string_view WhyIdle(std::string_view key) {
  if (Names(kOfBambuStudio, key)) return "acts in Bambu Studio only";
  if (key == "fan_direction") return "acts only if parts are turned automatically";
  return "no setting of OrcaSlicer, which ignores it (as of February 2026)";
}

}  // namespace slicefarm::config
