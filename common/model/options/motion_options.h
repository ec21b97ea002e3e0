#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/base/shared/shared_text.h"
#include "common/geometry/polygon.h"
#include "common/model/path.h"

namespace slicefarm {

/// What of a wall's width rests on the layer below: 0, 25, 50, 75 %.
inline constexpr int kOverhangDegrees = 4;

enum class GcodeFlavor { kMarlin2, kMarlinLegacy, kKlipper, kRepRapFirmware, kPrusaBuddy, kBambu };

/// The machine as its firmware sees it; the planner obeys the same rules, so that times are true.
struct MachineLimits {
  // x, y, z, e
  std::array<double, 4> max_feedrate_mm_s = {300, 300, 20, 120};  ///< machine_max_feedrate_x..e
  std::array<double, 4> max_acceleration_mm_s2 = {3000, 3000, 500,
                                                  3000};   ///< machine_max_acceleration_x..e
  std::array<double, 4> max_jerk_mm_s = {8, 8, 0.4, 2.5};  ///< machine_max_jerk_x..e (classic jerk)
  double max_acceleration_extruding_mm_s2 = 1500;          ///< machine_max_acceleration_extruding
  double max_acceleration_retracting_mm_s2 = 1500;         ///< machine_max_acceleration_retracting
  double max_acceleration_travel_mm_s2 = 3000;             ///< machine_max_acceleration_travel
  double junction_deviation_mm = 0;        ///< machine_max_junction_deviation; 0: classic jerk
  double square_corner_velocity_mm_s = 5;  ///< square_corner_velocity (Klipper)
  double minimum_cruise_ratio = 0.5;       ///< minimum_cruise_ratio (Klipper)
  double min_extruding_rate_mm_s = 0;      ///< machine_min_extruding_rate: no bead is slower
  double min_travel_rate_mm_s = 0;         ///< machine_min_travel_rate: nor is any travel
  double jerk_mm_s3 = 100'000;             ///< jerk_limit: change of acceleration (own planner)
  bool emit_to_gcode = false;              ///< machine_limits_usage = emit_to_gcode

  friend bool operator==(const MachineLimits&, const MachineLimits&) = default;
};

/// retract_lift_enforce: after which beads the nozzle rises for a travel.
enum class LiftAfter : uint8_t {
  kAll,
  kTop,           ///< tops and ironing
  kBottom,        ///< those of the first layer
  kTopAndBottom,  ///< both
};

struct RetractionOptions {
  double length_mm = 0.8;          ///< retract_length; 0: none
  double speed_mm_s = 35;          ///< retract_speed
  double restart_speed_mm_s = 35;  ///< deretract_speed (0 in the settings: as retract_speed)
  double restart_extra_mm = 0;     ///< retract_restart_extra
  double min_travel_mm = 2;        ///< retract_before_travel: shorter travels do not retract
  double lift_mm = 0;              ///< retract_lift
  double lift_above_mm = 0;        ///< retract_lift_above: no lift where the nozzle is lower
  double lift_below_mm = 0;        ///< retract_lift_below: nor higher than this; 0: however high
  LiftAfter lift_after = LiftAfter::kAll;  ///< retract_lift_enforce
  bool ramping = false;            ///< travel_ramping_lift: the nozzle rises on its way
  double ramp_lift_mm = 0;         ///< travel_max_lift: in place of lift_mm
  double ramp_slope_deg = 0;       ///< travel_slope; 0 and 90: straight up
  bool before_obstacles = false;   ///< travel_lift_before_obstacle: steeper where edges are near
  bool wipe = false;               ///< wipe: the nozzle goes on along the path while retracting
  double before_wipe = 0;          ///< retract_before_wipe: share of the length, in place

  friend bool operator==(const RetractionOptions&, const RetractionOptions&) = default;
};

struct CoolingOptions {
  bool enabled = true;                     ///< cooling
  bool fan_always_on = true;               ///< fan_always_on
  int32_t min_fan_percent = 35;            ///< min_fan_speed
  int32_t max_fan_percent = 100;           ///< max_fan_speed
  int32_t bridge_fan_percent = 100;        ///< bridge_fan_speed
  int32_t disable_fan_first_layers = 1;    ///< disable_fan_first_layers
  double fan_below_layer_time_s = 60;      ///< fan_below_layer_time
  double slowdown_below_layer_time_s = 5;  ///< slowdown_below_layer_time
  double min_print_speed_mm_s = 10;        ///< min_print_speed
  /// cooling_slowdown_logic = consistent_surface: outer walls are slowed down last.
  bool consistent_surface = false;
  double transition_mm = 10;  ///< cooling_perimeter_transition_distance, then, before outer walls
  int32_t full_fan_speed_layer = 0;  ///< full_fan_speed_layer: the fan grows up to it; 0: none
  bool dynamic_fan = false;          ///< enable_dynamic_fan_speeds
  /// overhang_fan_speed_0 to _3, by degree.
  std::array<int32_t, kOverhangDegrees> overhang_fan_percent = {};

  friend bool operator==(const CoolingOptions&, const CoolingOptions&) = default;
};

/// Which loops of a region get a scarf.
enum class ScarfPlacement : uint8_t {
  kNowhere,
  kContours,  ///< the outer contours of islands
  kEverywhere,
};

/// A scarf: a loop begins low and thin, rises, and ends over its own beginning, in place of a butt
/// joint that shows.
struct ScarfOptions {
  ScarfPlacement placement = ScarfPlacement::kNowhere;  ///< scarf_seam_placement
  bool only_on_smooth = true;     ///< scarf_seam_only_on_smooth: not at corners
  bool on_inner = false;          ///< scarf_seam_on_inner_perimeters
  bool entire_loop = false;       ///< scarf_seam_entire_loop: the length is the loop's
  double start_height_ratio = 0;  ///< scarf_seam_start_height: where it begins in the layer
  double length_mm = 20;          ///< scarf_seam_length
  double max_segment_mm = 1;      ///< scarf_seam_max_segment_length: of steps of the flow

  friend bool operator==(const ScarfOptions&, const ScarfOptions&) = default;
};

/// How the beads of one region are printed.
struct RegionSpeeds {
  std::array<double, kFeatureCount> speed_mm_s = {30, 60, 30, 20, 80, 20, 15,
                                                  60, 60, 60, 60, 15, 0};  ///< by Feature
  double small_perimeter_speed_mm_s = 15;  ///< small_perimeter_speed: loops of radius below 6.5 mm
  bool dynamic_overhangs = false;          ///< enable_dynamic_overhang_speeds
  /// overhang_speed_0 to _3, by degree.
  std::array<double, kOverhangDegrees> overhang_speed_mm_s = {15, 15, 20, 25};
  ScarfOptions scarf;
  /// overhangs: walls over nothing are bridges, with their speed, fan and flow.
  bool bridging_walls = false;
  double bridge_flow = 1;     ///< bridge_flow_ratio
  bool thick_bridges = true;  ///< thick_bridges: round threads as wide as the nozzle

  friend bool operator==(const RegionSpeeds&, const RegionSpeeds&) = default;
};

/// gcode_label_objects: how the G-code says which copy it prints.
enum class ObjectLabels : uint8_t {
  kNone,      ///< disabled
  kComments,  ///< octoprint
  kFirmware,  ///< firmware: EXCLUDE_OBJECT_START, M486
};

/// arc_fitting: how curves of many short moves are written.
enum class ArcFitting : uint8_t {
  kDisabled,    ///< disabled: move by move
  kEmitCenter,  ///< emit_center: as arcs, G2 and G3 with I and J
};

/// How the program is put into words, and into a file.
struct WritingOptions {
  bool relative_e = true;            ///< use_relative_e_distances
  bool volumetric_e = false;         ///< use_volumetric_e: filament in mm3 instead of mm
  bool firmware_retraction = false;  ///< use_firmware_retraction: G10 and G11
  bool comments = false;             ///< gcode_comments: what each line is for
  bool binary = false;               ///< binary_gcode
  SharedText substitutions;          ///< gcode_substitutions, as a config.ini has them
  std::string file_name;             ///< output_filename_format: a template
  SharedText height_code;            ///< custom_gcode_per_print_z (height_code.h); empty: none
  SharedText color_change_gcode;     ///< color_change_gcode
  SharedText pause_gcode;            ///< pause_print_gcode
  SharedText template_gcode;         ///< template_custom_gcode

  friend bool operator==(const WritingOptions&, const WritingOptions&) = default;
};

struct MotionOptions {
  GcodeFlavor flavor = GcodeFlavor::kMarlin2;  ///< gcode_flavor
  MachineLimits limits;
  /// silent_mode: the limits of the machine's silent mode, for a second estimate of the time.
  std::optional<MachineLimits> silent_limits;
  RetractionOptions retraction;
  CoolingOptions cooling;

  std::vector<RegionSpeeds> speeds = {{}};   ///< by region
  double travel_speed_mm_s = 130;            ///< travel_speed
  double first_layer_travel_speed_mm_s = 0;  ///< first_layer_travel_speed; 0: as the others
  double travel_speed_z_mm_s = 0;            ///< travel_speed_z; 0: the machine's z limit
  double first_layer_speed_mm_s = 30;        ///< first_layer_speed; 0: as above
  double first_layer_speed_ratio = 1;        ///< first_layer_speed in percent
  double first_layer_infill_speed_mm_s = 0;  ///< first_layer_infill_speed; 0: as the others
  double over_raft_speed_mm_s = 30;       ///< first_layer_speed_over_raft, on a raft; 0: as above
  double over_raft_speed_ratio = 1;       ///< first_layer_speed_over_raft in percent
  double max_print_speed_mm_s = 80;       ///< max_print_speed
  double max_volumetric_speed_mm3_s = 0;  ///< filament_max_volumetric_speed, 0: unlimited
  /// max_volumetric_extrusion_rate_slope_positive and _negative: how fast the flow may rise and
  /// fall; 0: at once.
  double flow_rise_mm3_s2 = 0;
  double flow_fall_mm3_s2 = 0;
  double pressure_advance = 0;  ///< pressure_advance, in the firmware's own unit; 0: left as it is

  /// By Feature, 0: default_acceleration. perimeter_acceleration, infill_acceleration, ...
  std::array<double, kFeatureCount> acceleration_mm_s2 = {};
  double default_acceleration_mm_s2 = 0;      ///< default_acceleration, 0: leave it to the firmware
  double first_layer_acceleration_mm_s2 = 0;  ///< first_layer_acceleration, 0: as above
  double over_raft_acceleration_mm_s2 = 0;    ///< first_layer_acceleration_over_raft, 0: as above
  double travel_acceleration_mm_s2 = 0;  ///< travel_acceleration, 0: the machine's travel limit

  /// travel_short_distance_acceleration: of travels to outer walls that are too short for a
  /// retraction; 0: as the others.
  double short_travel_acceleration_mm_s2 = 0;
  double seam_gap_mm = 0;  ///< seam_gap_distance: how much a closed path's end stays open

  double nozzle_diameter_mm = 0.4;       ///< nozzle_diameter
  double filament_diameter_mm = 1.75;    ///< filament_diameter
  double extrusion_multiplier = 1;       ///< extrusion_multiplier
  double filament_density_g_cm3 = 1.24;  ///< filament_density
  double filament_cost_per_kg = 0;       ///< filament_cost
  std::string filament_type = "PLA";     ///< filament_type
  std::string filament_colour;           ///< filament_colour
  std::string filament_settings_id;      ///< filament_settings_id
  std::string printer_model;             ///< printer_model

  int32_t temperature_c = 200;                ///< temperature
  int32_t first_layer_temperature_c = 200;    ///< first_layer_temperature
  int32_t bed_temperature_c = 0;              ///< bed_temperature
  int32_t first_layer_bed_temperature_c = 0;  ///< first_layer_bed_temperature

  int32_t chamber_temperature_c = 0;  ///< chamber_temperature
  int32_t chamber_least_c = 0;        ///< chamber_minimal_temperature: waited for
  /// activate_chamber_temp_control: else its temperatures are there for templates alone.
  bool heats_chamber = true;
  /// autoemit_temperature_commands: what start_gcode does not heat is heated around it.
  bool emit_temperatures = true;

  int32_t tool = -1;  ///< extruder - 1, chosen after start_gcode; -1: there is no choice

  double nozzle_heating_c_s = 0;  ///< nozzle_heating_rate, for times; 0: heating takes none
  double bed_heating_c_s = 0;     ///< bed_heating_rate

  bool progress = false;   ///< remaining_times: M73 before each layer
  double z_offset_mm = 0;  ///< z_offset
  Point extruder_offset;   ///< extruder_offset, in nm: taken off all places in the G-code
  SharedText start_gcode = "G28 ; home all axes\nG1 Z5 F5000 ; lift nozzle\n";  ///< start_gcode
  /// start_filament_gcode: after start_gcode, when all is hot and the tool is chosen.
  SharedText start_filament_gcode;
  SharedText end_gcode =
      "M104 S0 ; turn off temperature\nG28 X0 ; home X axis\nM84 ; disable motors\n";
  SharedText before_layer_gcode;  ///< before_layer_gcode
  SharedText layer_gcode;         ///< layer_gcode, with time_lapse_gcode
  /// The settings that these two name, as `key = value` lines.
  SharedText layer_settings;
  ObjectLabels labels = ObjectLabels::kNone;       ///< gcode_label_objects
  SharedText between_objects_gcode;                ///< between_objects_gcode
  Coord max_print_height_nm = 0;                   ///< max_print_height, 0: unlimited
  /// bed_shape without bed_exclude_area: travel stays in it; empty: nothing is excluded.
  MultiPolygon room;
  ArcFitting arc_fitting = ArcFitting::kDisabled;  ///< arc_fitting
  Coord resolution_nm = 12'500;  ///< gcode_resolution: paths are simplified within this; 0: not
  SharedText material_field;     ///< canonical text (fields/field_text.h); empty: no mixing
  WritingOptions writing;

  friend bool operator==(const MotionOptions&, const MotionOptions&) = default;
};

/// Whether walls or travels depend on what lies below them (PathBlock::below).
inline bool LooksBelow(const MotionOptions& options) {
  return options.cooling.dynamic_fan ||
         (options.retraction.ramping && options.retraction.before_obstacles) ||
         std::ranges::any_of(options.speeds, [](const RegionSpeeds& region) {
           return region.dynamic_overhangs || region.bridging_walls;
         });
}

}  // namespace slicefarm
