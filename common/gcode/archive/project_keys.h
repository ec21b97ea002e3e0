#pragma once

#include <string_view>

namespace slicefarm::gcode {

/// Setting that readers of archives search for, with its name in Bambu Studio. There, settings of
/// filaments and nozzles are lists.
struct ProjectKey {
  std::string_view key;
  std::string_view name;
  bool is_list = false;
};

inline constexpr ProjectKey kProjectKeys[] = {
    {"layer_height", "layer_height"},
    {"first_layer_height", "initial_layer_print_height"},
    {"perimeters", "wall_loops"},
    {"fill_density", "sparse_infill_density"},
    {"fill_pattern", "sparse_infill_pattern"},
    {"top_solid_layers", "top_shell_layers"},
    {"bottom_solid_layers", "bottom_shell_layers"},
    {"support_material", "enable_support"},
    {"brim_width", "brim_width"},
    {"spiral_vase", "spiral_mode"},
    {"max_print_height", "printable_height"},
    {"curr_bed_type", "curr_bed_type"},
    {"print_settings_id", "print_settings_id"},
    {"printer_settings_id", "printer_settings_id"},
    {"printer_model", "printer_model"},
    {"nozzle_diameter", "nozzle_diameter", true},
    {"temperature", "nozzle_temperature", true},
    {"first_layer_temperature", "nozzle_temperature_initial_layer", true},
    {"bed_temperature", "bed_temperature", true},
    {"bed_temperature", "hot_plate_temp", true},
    {"first_layer_bed_temperature", "bed_temperature_initial_layer", true},
    {"first_layer_bed_temperature", "hot_plate_temp_initial_layer", true},
    {"filament_type", "filament_type", true},
    {"filament_id", "filament_ids", true},
    {"filament_colour", "filament_colour", true},
    {"filament_diameter", "filament_diameter", true},
    {"filament_density", "filament_density", true},
    {"filament_cost", "filament_cost", true},
    {"filament_max_volumetric_speed", "filament_max_volumetric_speed", true},
    {"retract_length", "retraction_length", true},
};

}  // namespace slicefarm::gcode
