#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "common/base/shared/shared_text.h"
#include "common/geometry/point.h"
#include "common/model/options/region_motion.h"

namespace slicefarm {

/// `retract_lift_enforce`: features after which the nozzle is lifted for a travel.
enum class LiftAfter : uint8_t {
  kAll,
  kTop,           ///< beads of top surfaces and ironing
  kBottom,        ///< beads of the first layer
  kTopAndBottom,  ///< beads of the first layer, top surfaces and ironing
};

/// Options for retraction, lift and wipe of one tool. Member comments begin with the name of the
/// setting.
struct RetractionOptions {
  double length_mm = 0.8;          ///< setting retract_length; 0: no retraction
  double speed_mm_s = 35;          ///< setting retract_speed
  double restart_speed_mm_s = 35;  ///< setting deretract_speed (0 in the settings: retract_speed)
  double restart_extra_mm = 0;     ///< setting retract_restart_extra
  double min_travel_mm = 2;        ///< `retract_before_travel`: shorter travels do not retract
  double lift_mm = 0;              ///< setting retract_lift
  double lift_above_mm = 0;        ///< `retract_lift_above`: no lift below this nozzle height
  /// `retract_lift_below`: no lift above this nozzle height; 0: unlimited
  double lift_below_mm = 0;
  LiftAfter lift_after = LiftAfter::kAll;  ///< setting retract_lift_enforce
  bool ramping = false;       ///< `travel_ramping_lift`: the nozzle rises along the travel
  double ramp_lift_mm = 0;    ///< `travel_max_lift`: replaces lift_mm
  double ramp_slope_deg = 0;  ///< setting travel_slope; 0 and 90: vertical lift
  /// `travel_lift_before_obstacle`: the lift is steeper if walls of the part are near
  bool before_obstacles = false;
  /// `wipe`: the nozzle continues along the path while the filament is retracted
  bool wipe = false;
  /// `retract_before_wipe`: share of the length that is retracted before the wipe begins
  double before_wipe = 0;
  /// `retract_after_wipe`: share of the length that is retracted after the wipe
  double after_wipe = 0;
  /// `travel_spiral_lift`: the nozzle rises on a circle before the travel, with ramp_slope_deg
  bool spiral = false;
  /// `wipe_distance`: length of the wipe; 0: the wipe lasts as long as the retraction
  double wipe_distance_mm = 0;

  friend bool operator==(const RetractionOptions&, const RetractionOptions&) = default;
};

/// Options for the fan and for slower printing of short layers.
struct CoolingOptions {
  bool enabled = true;                     ///< setting cooling
  bool fan_always_on = true;               ///< setting fan_always_on
  int32_t min_fan_percent = 35;            ///< setting min_fan_speed
  int32_t max_fan_percent = 100;           ///< setting max_fan_speed
  int32_t bridge_fan_percent = 100;        ///< setting bridge_fan_speed
  int32_t disable_fan_first_layers = 1;    ///< setting disable_fan_first_layers
  double fan_below_layer_time_s = 60;      ///< setting fan_below_layer_time
  double slowdown_below_layer_time_s = 5;  ///< setting slowdown_below_layer_time
  double min_print_speed_mm_s = 10;        ///< setting min_print_speed
  /// `cooling_slowdown_logic = consistent_surface`: outer walls are slowed down last.
  bool consistent_surface = false;
  /// `cooling_perimeter_transition_distance`, used with consistent_surface: inner beads are slowed
  /// down like the outer wall if they end at most this length before it
  double transition_mm = 10;
  /// `full_fan_speed_layer`: layer up to which the fan speed rises; 0: no ramp
  int32_t full_fan_speed_layer = 0;
  bool dynamic_fan = false;  ///< setting enable_dynamic_fan_speeds
  /// `overhang_fan_speed_0` to `_3`: fan speed per overhang degree (kOverhangDegrees).
  std::array<int32_t, kOverhangDegrees> overhang_fan_percent = {};
  /// `overhang_fan_threshold`: smallest unsupported share of an outer wall's width for which the
  /// fan runs at bridge_fan_percent; 0: all outer walls; 1: only walls that are bridges
  double overhang_fan_share = 1;
  /// `support_material_interface_fan_speed`; -1: the layer's fan speed
  int32_t interface_fan_percent = -1;
  int32_t internal_bridge_fan_percent = -1;  ///< internal_bridge_fan_speed; -1: bridge_fan_percent
  int32_t ironing_fan_percent = -1;          ///< ironing_fan_speed; -1: the layer's fan speed
  int32_t first_layer_fan_percent = -1;      ///< first_layer_fan_speed; -1: as in other layers
  bool bridge_fan = true;  ///< `enable_overhang_bridge_fan`: bridges have a fan of their own
  /// `dont_slow_down_outer_wall`: outer walls keep their speed in short layers
  bool keep_outer_walls = false;

  friend bool operator==(const CoolingOptions&, const CoolingOptions&) = default;
};

/// Pressure advance that depends on the flow and the acceleration of a feature.
struct AdaptiveAdvance {
  bool on = false;    ///< setting adaptive_pressure_advance
  std::string model;  ///< `adaptive_pressure_advance_model` (advance_model.h); empty: none
  bool within_features = false;  ///< `adaptive_pressure_advance_overhangs`: at each flow change
  double bridges = 0;            ///< adaptive_pressure_advance_bridges; 0: by the model

  friend bool operator==(const AdaptiveAdvance&, const AdaptiveAdvance&) = default;
};

/// Settings of one tool: its nozzle and its filament.
struct ToolRow {
  RetractionOptions retraction;
  CoolingOptions cooling;

  double nozzle_diameter_mm = 0.4;  ///< setting nozzle_diameter
  Point offset;         ///< setting extruder_offset, subtracted from all positions in the G-code
  int32_t number = -1;  ///< number of the extruder from 0; -1: the machine has one tool
  double max_volumetric_speed_mm3_s = 0;  ///< setting filament_max_volumetric_speed; 0: unlimited
  /// `volumetric_speed_coefficients` with filament_adaptive_volumetric_speed: largest flow by the
  /// height and width of the bead (flow_fit.h); empty: max_volumetric_speed_mm3_s alone
  std::string flow_fit;
  double pressure_advance = 0;  ///< `pressure_advance` in the firmware's unit; 0: not set

  AdaptiveAdvance advance;

  double filament_diameter_mm = 1.75;    ///< setting filament_diameter
  double extrusion_multiplier = 1;       ///< setting extrusion_multiplier
  double filament_density_g_cm3 = 1.24;  ///< setting filament_density
  double filament_cost_per_kg = 0;       ///< setting filament_cost
  std::string filament_type = "PLA";     ///< setting filament_type
  std::string filament_colour;           ///< setting filament_colour
  std::string filament_settings_id;      ///< setting filament_settings_id

  int32_t temperature_c = 200;                ///< setting temperature
  int32_t first_layer_temperature_c = 200;    ///< setting first_layer_temperature
  int32_t bed_temperature_c = 0;              ///< setting bed_temperature
  int32_t first_layer_bed_temperature_c = 0;  ///< setting first_layer_bed_temperature
  int32_t chamber_temperature_c = 0;          ///< setting chamber_temperature
  /// `chamber_minimal_temperature`: temperature that the print waits for
  int32_t chamber_least_c = 0;
  /// `start_filament_gcode`: G-code after start_gcode, when all heaters are hot and the tool is
  /// selected.
  SharedText start_filament_gcode;

  friend bool operator==(const ToolRow&, const ToolRow&) = default;
};

}  // namespace slicefarm
