#include "common/config/presets/orca_defaults.h"

namespace slicefarm::config::presets {

std::string_view OrcaPrinterDefaults() {
  return R"(adaptive_bed_mesh_margin = 0
auxiliary_fan = 0
bbl_use_printhost = 0
bed_custom_model = 
bed_custom_texture = 
bed_exclude_area = 0x0
bed_mesh_max = 99999x99999
bed_mesh_min = -99999x-99999
bed_mesh_probe_distance = 50x50
before_layer_change_gcode = 
best_object_pos = 0.5x0.5
change_extrusion_role_gcode = 
change_filament_gcode = 
cooling_tube_length = 5
cooling_tube_retraction = 91.5
default_bed_type = 
default_filament_profile = 
default_print_profile = 
deretraction_speed = 0
disable_m73 = 0
emit_machine_limits_to_gcode = 1
enable_change_pressure_when_wiping = 1
enable_filament_ramming = 1
enable_long_retraction_when_cut = 0
extra_loading_move = -2
extruder_clearance_height_to_lid = 120
extruder_clearance_height_to_rod = 40
extruder_clearance_radius = 40
extruder_colour = 
extruder_offset = 0x0
fan_kickstart = 0
fan_speedup_overhangs = 1
fan_speedup_time = 0
gcode_flavor = marlin
head_wrap_detect_zone = 
high_current_on_filament_swap = 0
host_type = octoprint
layer_change_gcode = 
long_retractions_when_cut = 0
machine_end_gcode = M104 S0 ; turn off temperature\nG28 X0  ; home X axis\nM84     ; disable motors\n
machine_load_filament_time = 0
machine_max_acceleration_e = 5000
machine_max_acceleration_extruding = 1500
machine_max_acceleration_retracting = 1500
machine_max_acceleration_travel = 0
machine_max_acceleration_x = 1000
machine_max_acceleration_y = 1000
machine_max_acceleration_z = 500
machine_max_jerk_e = 2.5
machine_max_jerk_x = 10
machine_max_jerk_y = 10
machine_max_jerk_z = 0.2
machine_max_junction_deviation = 0
machine_max_speed_e = 120
machine_max_speed_x = 500
machine_max_speed_y = 500
machine_max_speed_z = 12
machine_min_extruding_rate = 0
machine_min_travel_rate = 0
machine_pause_gcode = 
machine_start_gcode = G28 ; home all axes\nG1 Z5 F5000 ; lift nozzle\n
machine_tool_change_time = 0
machine_unload_filament_time = 0
manual_filament_change = 0
max_layer_height = 0
max_resonance_avoidance_speed = 120
min_layer_height = 0.07
min_resonance_avoidance_speed = 70
nozzle_diameter = 0.4
nozzle_height = 2.5
nozzle_hrc = 0
nozzle_type = undefine
nozzle_volume = 0
parking_pos_retraction = 92
pellet_modded_printer = 0
preferred_orientation = 0
print_host = 
print_host_webui = 
printable_area = 0x0,200x0,200x200,0x200
printable_height = 100
printer_model = 
printer_notes = 
printer_structure = undefine
printer_technology = FFF
printer_variant = 
printhost_apikey = 
printhost_authorization_type = key
printhost_cafile = 
printhost_password = 
printhost_port = 
printhost_ssl_ignore_revoke = 0
printhost_user = 
printing_by_object_gcode = 
purge_in_prime_tower = 1
ramming_line_width_ratio = 2
ramming_pressure_advance_value = 0
resonance_avoidance = 0
retract_before_wipe = 100%
retract_length_toolchange = 10
retract_lift_above = 0
retract_lift_below = 0
retract_lift_enforce = All Surfaces
retract_restart_extra = 0
retract_restart_extra_toolchange = 0
retract_when_changing_layer = 0
retraction_distances_when_cut = 18
retraction_length = 0.8
retraction_minimum_travel = 2
retraction_speed = 30
scan_first_layer = 0
silent_mode = 0
single_extruder_multi_material = 1
support_air_filtration = 1
support_chamber_temp_control = 1
support_multi_bed_types = 0
template_custom_gcode = 
thumbnails = 48x48/PNG,300x300/PNG
thumbnails_format = PNG
time_cost = 0
time_lapse_gcode = 
tool_change_temprature_wait = 1
travel_slope = 3
upward_compatible_machine = 
use_firmware_retraction = 0
use_relative_e_distances = 1
wipe = 0
wipe_distance = 1
z_hop = 0.4
z_hop_types = Slope Lift
z_hop_when_prime = 1
z_offset = 0
)";
}

std::string_view OrcaFilamentDefaults() {
  return R"(activate_air_filtration = 0
activate_chamber_temp_control = 0
adaptive_pressure_advance = 0
adaptive_pressure_advance_bridges = 0
adaptive_pressure_advance_model = 0,0,0\n0,0,0
adaptive_pressure_advance_overhangs = 0
additional_cooling_fan_speed = 0
chamber_temperature = 0
close_fan_the_first_x_layers = 1
complete_print_exhaust_fan_speed = 80
cool_plate_temp = 35
cool_plate_temp_initial_layer = 35
default_filament_colour = 
dont_slow_down_outer_wall = 0
during_print_exhaust_fan_speed = 60
enable_overhang_bridge_fan = 1
enable_pressure_advance = 0
eng_plate_temp = 45
eng_plate_temp_initial_layer = 45
fan_cooling_layer_time = 60
fan_max_speed = 100
fan_min_speed = 20
filament_colour = #F2754E
filament_cooling_final_speed = 3.4
filament_cooling_initial_speed = 2.2
filament_cooling_moves = 4
filament_cost = 0
filament_density = 0
filament_deretraction_speed
filament_diameter = 1.75
filament_end_gcode =  
filament_flow_ratio = 1
filament_is_support = 0
filament_loading_speed = 28
filament_loading_speed_start = 3
filament_long_retractions_when_cut
filament_max_volumetric_speed = 2
filament_minimal_purge_on_wipe_tower = 15
filament_multitool_ramming = 0
filament_multitool_ramming_flow = 10
filament_multitool_ramming_volume = 10
filament_notes = 
filament_ramming_parameters
filament_retract_before_wipe
filament_retract_length_toolchange
filament_retract_lift_above
filament_retract_lift_below
filament_retract_lift_enforce
filament_retract_restart_extra
filament_retract_restart_extra_toolchange
filament_retract_when_changing_layer
filament_retraction_distances_when_cut
filament_retraction_length
filament_retraction_minimum_travel
filament_retraction_speed
filament_seam_gap
filament_shrink = 100%
filament_shrinkage_compensation_z = 100%
filament_soluble = 0
filament_stamping_distance = 0
filament_stamping_loading_speed = 0
filament_start_gcode =  
filament_toolchange_delay = 0
filament_type = PLA
filament_unloading_speed = 90
filament_unloading_speed_start = 100
filament_vendor = (Undefined)
filament_wipe
filament_wipe_distance
filament_z_hop
filament_z_hop_types
full_fan_speed_layer = 0
hot_plate_temp = 45
hot_plate_temp_initial_layer = 45
idle_temperature = 0
internal_bridge_fan_speed = -1
ironing_fan_speed = -1
nozzle_temperature = 200
nozzle_temperature_initial_layer = 200
nozzle_temperature_range_high = 240
nozzle_temperature_range_low = 190
overhang_fan_speed = 100
overhang_fan_threshold = 95%
pellet_flow_coefficient = 0.4157
pressure_advance = 0.02
reduce_fan_stop_start_freq = 0
required_nozzle_HRC = 0
slow_down_for_layer_cooling = 1
slow_down_layer_time = 5
slow_down_min_speed = 10
supertack_plate_temp = 35
supertack_plate_temp_initial_layer = 35
support_material_interface_fan_speed = -1
temperature_vitrification = 100
textured_cool_plate_temp = 40
textured_cool_plate_temp_initial_layer = 40
textured_plate_temp = 45
textured_plate_temp_initial_layer = 45
)";
}

}  // namespace slicefarm::config::presets
