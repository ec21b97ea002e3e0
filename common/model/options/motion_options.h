#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "common/base/shared/shared_text.h"
#include "common/geometry/polygon.h"
#include "common/model/options/machine_limits.h"
#include "common/model/options/region_motion.h"
#include "common/model/options/tool_row.h"
#include "common/model/path.h"

namespace slicefarm {

/// `gcode_label_objects`: form in which the G-code names the printed copy.
enum class ObjectLabels : uint8_t {
  kNone,      ///< `disabled`: no labels
  kComments,  ///< `octoprint`: comments
  kFirmware,  ///< `firmware`: commands EXCLUDE_OBJECT_START or M486
};

/// `arc_fitting`: form in which curves of many short moves are written.
enum class ArcFitting : uint8_t {
  kDisabled,    ///< `disabled`: single moves
  kEmitCenter,  ///< `emit_center`: arcs, G2 and G3 with I and J
};

/// Options for the text of the program and for its file.
struct WritingOptions {
  bool relative_e = true;            ///< setting use_relative_e_distances
  bool volumetric_e = false;         ///< `use_volumetric_e`: filament in mm3 instead of mm
  bool firmware_retraction = false;  ///< `use_firmware_retraction`: retracts by G10 and G11
  bool comments = false;     ///< `gcode_comments`: adds the purpose of each line as a comment
  bool binary = false;       ///< setting binary_gcode
  bool archive = false;      ///< `gcode_3mf`: puts the G-code into a .gcode.3mf archive
  SharedText substitutions;  ///< setting gcode_substitutions, in the form of a config.ini
  std::string file_name;     ///< `output_filename_format`: template of the file's name
  /// Setting custom_gcode_per_print_z (height_code.h); empty: no codes.
  SharedText height_code;
  SharedText color_change_gcode;  ///< setting color_change_gcode
  SharedText pause_gcode;         ///< setting pause_print_gcode
  SharedText template_gcode;      ///< setting template_custom_gcode

  friend bool operator==(const WritingOptions&, const WritingOptions&) = default;
};

/// Greatest change of speed at a corner (jerk). Klipper has the square corner velocity instead.
struct JerkOptions {
  /// `perimeter_jerk`, `infill_jerk`, ...: jerk in x and y per Feature. 0: default_jerk.
  std::array<double, kFeatureCount> feature_mm_s = {};
  double default_mm_s = 0;      ///< setting default_jerk; 0: no command sets the jerk
  double first_layer_mm_s = 0;  ///< setting first_layer_jerk; 0: the feature's jerk
  double travel_mm_s = 0;       ///< setting travel_jerk; 0: the jerk set last
  /// Setting first_layer_travel_jerk; 0: first_layer_jerk, or travel_jerk if both are 0.
  double first_layer_travel_mm_s = 0;
  /// `default_junction_deviation`: junction deviation of Marlin; 0: no command sets it.
  double junction_deviation_mm = 0;

  friend bool operator==(const JerkOptions&, const JerkOptions&) = default;
};

/// Speeds at which the machine resonates. Outer walls are not printed at them.
struct ResonanceOptions {
  bool avoid = false;       ///< setting resonance_avoidance
  double from_mm_s = 70;    ///< `min_resonance_avoidance_speed`: speed of walls in the range
  double until_mm_s = 120;  ///< setting max_resonance_avoidance_speed

  friend bool operator==(const ResonanceOptions&, const ResonanceOptions&) = default;
};

/// Machine that moves the bed along y, for templates that limit its acceleration.
struct BedMotor {
  double force_n = 0;           ///< setting machine_max_force_y; 0: no limit by the mass
  double bed_mass_g = 0;        ///< setting machine_bed_mass_y
  double max_print_mass_g = 0;  ///< setting machine_max_printed_mass; 0: unlimited

  friend bool operator==(const BedMotor&, const BedMotor&) = default;
};

/// Flow and reach of the turns of a spiral (spiral_vase).
struct SpiralMotion {
  /// `spiral_vase_starting_flow_ratio`: flow at the start of the first turn
  double start_flow = 0;
  /// `spiral_vase_finishing_flow_ratio`: flow at the end of the last turn
  double end_flow = 0;
  /// `spiral_vase_max_xy_smoothing`: longest shift of a point towards the turn below; 0: four beads
  Coord reach_nm = 0;

  friend bool operator==(const SpiralMotion&, const SpiralMotion&) = default;
};

/// Machine settings for motion planning and G-code.
struct MachineMotion {
  GcodeFlavor flavor = GcodeFlavor::kMarlin2;  ///< setting gcode_flavor
  MachineLimits limits;
  /// `silent_mode`: limits of the machine's silent mode, for a second time estimate.
  std::optional<MachineLimits> silent_limits;

  double travel_speed_mm_s = 130;            ///< setting travel_speed
  double first_layer_travel_speed_mm_s = 0;  ///< setting first_layer_travel_speed; 0: travel_speed
  double travel_speed_z_mm_s = 0;            ///< setting travel_speed_z; 0: the machine's z limit
  /// Setting first_layer_speed; 0: first_layer_speed_ratio applies.
  double first_layer_speed_mm_s = 30;
  /// Used if first_layer_speed is a percentage: its share of the feature's speed; 1 means 100 %.
  double first_layer_speed_ratio = 1;
  /// `first_layer_infill_speed`: speed of solid infill in the first layer; 0: first_layer_speed
  double first_layer_infill_speed_mm_s = 0;
  /// `first_layer_speed_over_raft`: speed of the layer on a raft; 0: over_raft_speed_ratio applies
  double over_raft_speed_mm_s = 30;
  /// Used if first_layer_speed_over_raft is a percentage: its share of the feature's speed; 1 means
  /// 100 %.
  double over_raft_speed_ratio = 1;
  /// `slow_down_layers`: number of layers over which speeds rise from the first layer's speeds
  int32_t slow_down_layers = 0;
  double max_print_speed_mm_s = 80;  ///< setting max_print_speed
  /// `wipe_speed`, as a share of travel_speed; not used with role_based_wipe_speed
  double wipe_speed_ratio = 0.8;
  bool wipe_as_printed =
      false;  ///< `role_based_wipe_speed`: a wipe has the speed of the bead before it
  /// `max_volumetric_extrusion_rate_slope_positive` and `_negative`: largest rise and fall of the
  /// flow per time; 0: unlimited.
  double flow_rise_mm3_s2 = 0;
  double flow_fall_mm3_s2 = 0;

  /// Acceleration per Feature, from the settings `perimeter_acceleration`, `infill_acceleration`,
  /// ...; 0: default_acceleration.
  std::array<double, kFeatureCount> acceleration_mm_s2 = {};
  double default_acceleration_mm_s2 = 0;  ///< setting default_acceleration; 0: the firmware decides
  /// Setting first_layer_acceleration; 0: the feature's acceleration.
  double first_layer_acceleration_mm_s2 = 0;
  /// Setting first_layer_acceleration_over_raft; 0: the feature's acceleration.
  double over_raft_acceleration_mm_s2 = 0;
  /// Setting travel_acceleration; 0: the machine's limit for travels.
  double travel_acceleration_mm_s2 = 0;

  /// `travel_short_distance_acceleration`: acceleration of travels to outer walls that are too
  /// short for a retraction. 0: the acceleration of all travels.
  double short_travel_acceleration_mm_s2 = 0;
  /// `first_layer_travel_acceleration`: acceleration of travels in the first layer; 0: as other
  /// travels.
  double first_layer_travel_acceleration_mm_s2 = 0;
  /// `accel_to_decel`: acceleration of short moves relative to that of long ones (Klipper); 0: no
  /// command sets it.
  double accel_to_decel = 0;

  JerkOptions jerk;

  /// `slowdown_for_curled_perimeters`: walls above curled edges are slower
  bool slow_curled = false;
  bool clockwise = false;    ///< JobOrder::clockwise
  double fan_speedup_s = 0;  ///< `fan_speedup_time`: time by which the fan starts before its beads
  bool fan_speedup_all = false;  ///< fan_speedup_overhangs = 0: speedup for all faster fans
  /// `fan_kickstart`: time at full speed before the fan turns faster by 100 %
  double fan_kickstart_s = 0;
  int32_t fan_least_percent = 0;  ///< `part_cooling_fan_min_pwm`: least speed of a fan that runs
  ResonanceOptions resonance;
  BedMotor bed_motor;
  SpiralMotion spiral;
  /// max_volumetric_extrusion_rate_slope_segment_length: length of beads with one flow
  double flow_segment_mm = 1;
  /// `extrusion_rate_smoothing_external_perimeter_only`: the flow of other lines may change at once
  bool flow_slopes_of_outer_walls = false;
  double seam_gap_mm = 0;  ///< `seam_gap_distance`: length of the gap at the end of a closed path

  std::string printer_model;  ///< setting printer_model

  /// `activate_chamber_temp_control`. If false, no command for the chamber temperature is written;
  /// the temperature is only a variable of templates.
  bool heats_chamber = true;
  /// `autoemit_temperature_commands`: adds heating commands around start_gcode for the heaters that
  /// start_gcode does not heat.
  bool emit_temperatures = true;

  /// Setting nozzle_heating_rate, for the estimated time; 0: the heating time is not counted.
  double nozzle_heating_c_s = 0;
  double bed_heating_c_s = 0;  ///< setting bed_heating_rate; 0: the heating time is not counted

  bool progress = false;   ///< `remaining_times`: writes M73 before each layer
  double z_offset_mm = 0;  ///< setting z_offset
  /// Setting start_gcode.
  SharedText start_gcode = "G28 ; home all axes\nG1 Z5 F5000 ; lift nozzle\n";
  SharedText end_gcode =
      "M104 S0 ; turn off temperature\nG28 X0 ; home X axis\nM84 ; disable motors\n";
  SharedText before_layer_gcode;  ///< setting before_layer_gcode
  SharedText layer_gcode;         ///< setting layer_gcode, including time_lapse_gcode
  /// `change_extrusion_role_gcode`, then the filament's and the process's: G-code before the first
  /// bead of another feature.
  SharedText role_gcode;
  SharedText file_start_gcode;  ///< setting file_start_gcode
  double cost_per_hour = 0;     ///< setting time_cost
  /// Settings that before_layer_gcode, layer_gcode and role_gcode refer to, as `key = value` lines.
  SharedText layer_settings;
  ObjectLabels labels = ObjectLabels::kNone;  ///< setting gcode_label_objects
  SharedText between_objects_gcode;           ///< setting between_objects_gcode
  Coord max_print_height_nm = 0;              ///< setting max_print_height; 0: unlimited
  /// Area that travels must not leave: `bed_shape` without `bed_exclude_area`. Empty: no area is
  /// excluded.
  MultiPolygon travel_area;
  ArcFitting arc_fitting = ArcFitting::kDisabled;  ///< setting arc_fitting
  /// `gcode_resolution`: tolerance to which paths are simplified; 0: no simplification
  Coord resolution_nm = 12'500;
  SharedText material_field;  ///< canonical text of a field (fields/field_text.h); empty: no mixing
  WritingOptions writing;

  friend bool operator==(const MachineMotion&, const MachineMotion&) = default;
};

/// Options of the motion stage.
struct MotionOptions : MachineMotion {
  std::vector<ToolRow> tools = {{}};        ///< options of each tool
  std::vector<RegionMotion> speeds = {{}};  ///< options of each region

  /// Returns the tool that prints.
  const ToolRow& tool() const { return tools.front(); }
  ToolRow& tool() { return tools.front(); }

  using Row = MachineMotion;
  template <typename Self>
  static auto TablesOf(Self& self) {
    return std::tie(self.tools, self.speeds);
  }
  friend bool operator==(const MotionOptions&, const MotionOptions&) = default;
};

/// Returns true if the fan speed depends on how much of a wall's width rests on the layer below.
inline bool CoolsByRest(const CoolingOptions& cooling) {
  return cooling.overhang_fan_share > 0 && cooling.overhang_fan_share < 1;
}

/// Returns true if walls or travels depend on the area that the layer below covers
/// (PathBlock::below).
inline bool LooksBelow(const MotionOptions& options) {
  return options.tool().cooling.dynamic_fan || CoolsByRest(options.tool().cooling) ||
         options.slow_curled ||
         (options.tool().retraction.ramping && options.tool().retraction.before_obstacles) ||
         std::ranges::any_of(options.speeds, [](const RegionMotion& region) {
           return region.dynamic_overhangs || region.bridging_walls || region.reversal.on ||
                  LimitsOverhang(region.scarf);
         });
}

}  // namespace slicefarm
