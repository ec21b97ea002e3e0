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
#include "common/model/options/region_speeds.h"
#include "common/model/options/tool_row.h"
#include "common/model/path.h"

namespace slicefarm {

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

/// Settings of a machine that motion planning and G-code need.
struct MachineMotion {
  GcodeFlavor flavor = GcodeFlavor::kMarlin2;  ///< gcode_flavor
  MachineLimits limits;
  /// silent_mode: the limits of the machine's silent mode, for a second estimate of the time.
  std::optional<MachineLimits> silent_limits;

  double travel_speed_mm_s = 130;            ///< travel_speed
  double first_layer_travel_speed_mm_s = 0;  ///< first_layer_travel_speed; 0: as the others
  double travel_speed_z_mm_s = 0;            ///< travel_speed_z; 0: the machine's z limit
  double first_layer_speed_mm_s = 30;        ///< first_layer_speed; 0: as above
  double first_layer_speed_ratio = 1;        ///< first_layer_speed in percent
  double first_layer_infill_speed_mm_s = 0;  ///< first_layer_infill_speed; 0: as the others
  double over_raft_speed_mm_s = 30;  ///< first_layer_speed_over_raft, on a raft; 0: as above
  double over_raft_speed_ratio = 1;  ///< first_layer_speed_over_raft in percent
  double max_print_speed_mm_s = 80;  ///< max_print_speed
  /// max_volumetric_extrusion_rate_slope_positive and _negative: how fast the flow may rise and
  /// fall; 0: at once.
  double flow_rise_mm3_s2 = 0;
  double flow_fall_mm3_s2 = 0;

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

  std::string printer_model;  ///< printer_model

  /// activate_chamber_temp_control: else its temperatures are there for templates alone.
  bool heats_chamber = true;
  /// autoemit_temperature_commands: what start_gcode does not heat is heated around it.
  bool emit_temperatures = true;

  double nozzle_heating_c_s = 0;  ///< nozzle_heating_rate, for times; 0: heating takes none
  double bed_heating_c_s = 0;     ///< bed_heating_rate

  bool progress = false;   ///< remaining_times: M73 before each layer
  double z_offset_mm = 0;  ///< z_offset
  SharedText start_gcode = "G28 ; home all axes\nG1 Z5 F5000 ; lift nozzle\n";  ///< start_gcode
  SharedText end_gcode =
      "M104 S0 ; turn off temperature\nG28 X0 ; home X axis\nM84 ; disable motors\n";
  SharedText before_layer_gcode;  ///< before_layer_gcode
  SharedText layer_gcode;         ///< layer_gcode, with time_lapse_gcode
  /// The settings that these two name, as `key = value` lines.
  SharedText layer_settings;
  ObjectLabels labels = ObjectLabels::kNone;  ///< gcode_label_objects
  SharedText between_objects_gcode;           ///< between_objects_gcode
  Coord max_print_height_nm = 0;              ///< max_print_height, 0: unlimited
  /// bed_shape without bed_exclude_area: travel stays in it; empty: nothing is excluded.
  MultiPolygon room;
  ArcFitting arc_fitting = ArcFitting::kDisabled;  ///< arc_fitting
  Coord resolution_nm = 12'500;  ///< gcode_resolution: paths are simplified within this; 0: not
  SharedText material_field;     ///< canonical text (fields/field_text.h); empty: no mixing
  WritingOptions writing;

  friend bool operator==(const MachineMotion&, const MachineMotion&) = default;
};

/// Options of the motion stage.
struct MotionOptions : MachineMotion {
  std::vector<ToolRow> tools = {{}};        ///< options of each tool
  std::vector<RegionSpeeds> speeds = {{}};  ///< options of each region

  /// The tool that prints.
  const ToolRow& tool() const { return tools.front(); }
  ToolRow& tool() { return tools.front(); }

  using Row = MachineMotion;
  template <typename Self>
  static auto TablesOf(Self& self) {
    return std::tie(self.tools, self.speeds);
  }
  friend bool operator==(const MotionOptions&, const MotionOptions&) = default;
};

/// Whether walls or travels depend on what lies below them (PathBlock::below).
inline bool LooksBelow(const MotionOptions& options) {
  return options.tool().cooling.dynamic_fan ||
         (options.tool().retraction.ramping && options.tool().retraction.before_obstacles) ||
         std::ranges::any_of(options.speeds, [](const RegionSpeeds& region) {
           return region.dynamic_overhangs || region.bridging_walls;
         });
}

}  // namespace slicefarm
