#include "common/config/table/shared_settings.h"
#include "processes/fdm/settings/table/needs.h"
#include "processes/fdm/settings/table/settings_sections.h"

namespace slicefarm::config::fdm {
namespace {

enum Axis { kX, kY, kZ, kE };

SettingSpec Limit(std::string_view key, std::string_view unit, double min, double max,
                  std::string_view standard, std::string_view doc, Field field) {
  return {.key = key,
          .unit = unit,
          .min = min,
          .max = max,
          .standard = standard,
          .doc = doc,
          .list = List::kPerMode,
          .field = field};
}

template <Axis kAxis>
std::vector<SettingSpec> AxisLimits(std::array<std::string_view, 3> keys,
                                    std::array<std::string_view, 3> standards) {
  return {
      Limit(keys[0], "mm/s", 0.001, 100'000, standards[0],
            "Speed limit of this axis, used as machine_limits_usage says",
            Bind<&MachineRow::motion, &MachineMotion::limits, &MachineLimits::max_feedrate_mm_s,
                 kAxis>()),
      Limit(keys[1], "mm/s2", 0.001, 1e6, standards[1],
            "Acceleration limit of this axis, used as machine_limits_usage says",
            Bind<&MachineRow::motion, &MachineMotion::limits,
                 &MachineLimits::max_acceleration_mm_s2, kAxis>()),
      Needing({kAxis == kX || kAxis == kY ? &needs::kMarlinOrJerk : &needs::kMarlin},
              Limit(keys[2], "mm/s", 0, 100'000, standards[2],
                    "Largest sudden change of speed of this axis at corners (Marlin's classic "
                    "jerk), used as machine_limits_usage says",
                    Bind<&MachineRow::motion, &MachineMotion::limits, &MachineLimits::max_jerk_mm_s,
                         kAxis>())),
  };
}

std::vector<SettingSpec> WholeMachineLimits() {
  return {
      Orca({"machine_max_acceleration_extruding"},
           Limit("machine_max_acceleration_extruding", "mm/s2", 0, 1e6, "1500",
                 "Acceleration limit of moves with extrusion, used as machine_limits_usage says; "
                 "0: no limit",
                 Bind<&MachineRow::motion, &MachineMotion::limits,
                      &MachineLimits::max_acceleration_extruding_mm_s2>())),
      Orca(
          {"machine_max_acceleration_retracting"},
          Limit("machine_max_acceleration_retracting", "mm/s2", 0, 1e6, "1500",
                "Acceleration limit of retractions, used as machine_limits_usage says; 0: no limit",
                Bind<&MachineRow::motion, &MachineMotion::limits,
                     &MachineLimits::max_acceleration_retracting_mm_s2>())),
      Orca({"machine_max_acceleration_travel"},
           Limit("machine_max_acceleration_travel", "mm/s2", 0, 1e6, "1500",
                 "Acceleration limit of travels, used as machine_limits_usage says; 0: no limit",
                 Bind<&MachineRow::motion, &MachineMotion::limits,
                      &MachineLimits::max_acceleration_travel_mm_s2>())),
      Orca(
          {"machine_max_junction_deviation"},
          Needing(
              {&needs::kMarlin},
              Limit("machine_max_junction_deviation", "mm", 0, 10, "0",
                    "Junction deviation of Marlin; larger: faster through corners. 0: the firmware "
                    "uses classic jerk",
                    Bind<&MachineRow::motion, &MachineMotion::limits,
                         &MachineLimits::junction_deviation_mm>()))),
      Needing({&needs::kKlipper}, Limit("square_corner_velocity", "mm/s", 0, 1000, "5",
                                        "Speed at which the printer passes a corner of 90 degrees "
                                        "(Klipper's square_corner_velocity), used as "
                                        "machine_limits_usage says; larger: faster through corners",
                                        Bind<&MachineRow::motion, &MachineMotion::limits,
                                             &MachineLimits::square_corner_velocity_mm_s>())),
      Needing({&needs::kKlipper}, Limit("minimum_cruise_ratio", "", 0, 0.99, "0.5",
                                        "Smallest share of a short move that runs at constant "
                                        "speed (Klipper's minimum_cruise_ratio); larger: lower top "
                                        "speed on short moves. Used for the estimated time",
                                        Bind<&MachineRow::motion, &MachineMotion::limits,
                                             &MachineLimits::minimum_cruise_ratio>())),
      Orca({"machine_min_extruding_rate"},
           Limit("machine_min_extruding_rate", "mm/s", 0, 1000, "0",
                 "Lowest speed of moves with extrusion that the firmware allows; used as "
                 "machine_limits_usage says. 0: no limit",
                 Bind<&MachineRow::motion, &MachineMotion::limits,
                      &MachineLimits::min_extruding_rate_mm_s>())),
      Orca({"machine_min_travel_rate"}, Limit("machine_min_travel_rate", "mm/s", 0, 1000, "0",
                                              "Lowest speed of travels that the firmware allows; "
                                              "used as machine_limits_usage says. 0: no limit",
                                              Bind<&MachineRow::motion, &MachineMotion::limits,
                                                   &MachineLimits::min_travel_rate_mm_s>())),
      Limit("jerk_limit", "mm/s3", 1, 1e8, "100000",
            "Largest change of acceleration per second in slicefarm's own motion planner, for the "
            "estimated time of machines that have no firmware",
            Bind<&MachineRow::motion, &MachineMotion::limits, &MachineLimits::jerk_mm_s3>()),
      {.key = "silent_mode",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Estimate the print time in Marlin's silent mode as well, with the second value of "
              "each machine_max_ setting"},
      {.key = "machine_limits_usage",
       .kind = Kind::kChoice,
       .standard = "time_estimate_only",
       .doc = "Use of the machine_max_ and machine_min_ settings. emit_to_gcode: for the estimated "
              "time, and written into the G-code. time_estimate_only: only for the estimated time. "
              "ignore: none; the estimated time uses the defaults of these settings",
       .choices = {{"time_estimate_only", 0}, {"emit_to_gcode", 1}, {"ignore", kIgnoreLimits}},
       .field = Convert<MachineRow>(
           [](MachineRow& row, const Value& value) {
             row.motion.limits.emit_to_gcode = value.number == 1;
           },
           [](const MachineRow& row) {
             return Value{.number = row.motion.limits.emit_to_gcode ? 1.0 : 0.0};
           })},
  };
}

std::vector<SettingSpec> Machine() {
  const auto flavor = [](GcodeFlavor f) { return static_cast<int>(f); };
  const auto labels = [](ObjectLabels l) { return static_cast<int>(l); };
  constexpr std::string_view kAsMarlin = "not supported yet: marlin2 is used";
  return {
      {.key = "gcode_flavor",
       .kind = Kind::kChoice,
       .standard = "marlin2",
       .doc = "Firmware of the printer, which determines the commands in the G-code",
       .choices = {{"marlin2", flavor(GcodeFlavor::kMarlin2)},
                   {"marlin", flavor(GcodeFlavor::kMarlinLegacy)},
                   {"klipper", flavor(GcodeFlavor::kKlipper)},
                   {"reprap", flavor(GcodeFlavor::kMarlin2), kAsMarlin},
                   {"reprapfirmware", flavor(GcodeFlavor::kRepRapFirmware)},
                   {"prusabuddy", flavor(GcodeFlavor::kPrusaBuddy)},
                   {"bambu", flavor(GcodeFlavor::kBambu)},
                   {"repetier", flavor(GcodeFlavor::kMarlin2), kAsMarlin},
                   {"rapid", flavor(GcodeFlavor::kMarlin2), kAsMarlin},
                   {"teacup", flavor(GcodeFlavor::kMarlin2), kAsMarlin},
                   {"makerware", flavor(GcodeFlavor::kMarlin2), kAsMarlin},
                   {"sailfish", flavor(GcodeFlavor::kMarlin2), kAsMarlin},
                   {"mach3", flavor(GcodeFlavor::kMarlin2), kAsMarlin},
                   {"machinekit", flavor(GcodeFlavor::kMarlin2), kAsMarlin},
                   {"smoothie", flavor(GcodeFlavor::kMarlin2), kAsMarlin},
                   {"no-extrusion", flavor(GcodeFlavor::kMarlin2), kAsMarlin}},
       .field = Bind<&MachineRow::motion, &MachineMotion::flavor>(),
       .orca = {{"gcode_flavor"}}},
      {.key = "material_field",
       .kind = Kind::kMaterialField,
       .standard = "",
       .doc = "Mixing ratio of the materials of a mixing extruder by position on the plate, as a "
              "field in JSON; empty: no mixing",
       .field = Bind<&MachineRow::motion, &MachineMotion::material_field>()},
      {.key = "nozzle_diameter",
       .unit = "mm",
       .min = 0.05,
       .max = 10,
       .standard = "0.4",
       .doc = "Diameter of the nozzle",
       .list = List::kPerExtruder,
       .field = Bind<&ToolRow::nozzle_diameter_mm>(),
       .also = Bind<&RegionRow::infill, &InfillOptions::nozzle_nm>(),
       .orca = {{"nozzle_diameter"}}},
      {.key = "nozzle_heating_rate",
       .unit = "C/s",
       .min = 0,
       .max = 1000,
       .standard = "0",
       .doc =
           "Heating rate of the nozzle, for the estimated time; 0: the heating time is not counted",
       .field = Bind<&MachineRow::motion, &MachineMotion::nozzle_heating_c_s>()},
      {.key = "bed_heating_rate",
       .unit = "C/s",
       .min = 0,
       .max = 1000,
       .standard = "0",
       .doc = "Heating rate of the bed, for the estimated time; 0: the heating time is not counted",
       .field = Bind<&MachineRow::motion, &MachineMotion::bed_heating_c_s>()},
      {.key = "autoemit_temperature_commands",
       .kind = Kind::kFlag,
       .standard = "1",
       .doc = "Add the heating commands that start_gcode lacks (M104, M109, M140, M190, M141, "
              "M191); 0: no heating commands are added at the start",
       .field = Bind<&MachineRow::motion, &MachineMotion::emit_temperatures>()},
      {.key = "z_offset",
       .unit = "mm",
       .min = -100,
       .max = 100,
       .standard = "0",
       .doc = "Offset that is added to every z coordinate in the G-code; negative: the nozzle is "
              "closer to the bed",
       .field = Bind<&MachineRow::motion, &MachineMotion::z_offset_mm>(),
       .orca = {{"z_offset"}}},
      {.key = "extruder_offset",
       .kind = Kind::kPoint,
       .unit = "mm",
       .standard = "0x0",
       .doc = "Offset of the nozzle from the print head, in mm; it is subtracted from all "
              "positions in the G-code",
       .list = List::kPerExtruder,
       .field = Bind<&ToolRow::offset>(),
       .orca = {{"extruder_offset"}}},
      {.key = "remaining_times",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Write the progress and the remaining time for the printer's display before each "
              "layer (M73)",
       .field = Bind<&MachineRow::motion, &MachineMotion::progress>()},
      {.key = "fan_speedup_time",
       .unit = "s",
       .min = 0,
       .max = 60,
       .standard = "0",
       .doc = "Time by which the fan is made faster before the line that needs it, because a fan "
              "starts slowly; not earlier than the copy's first move in the layer. 0: at the start "
              "of the line",
       .field = Bind<&MachineRow::motion, &MachineMotion::fan_speedup_s>(),
       .orca = {{"fan_speedup_time"}}},
      {.key = "fan_speedup_overhangs",
       .kind = Kind::kFlag,
       .standard = "1",
       .doc = "Apply fan_speedup_time only where the fan becomes faster for bridges and overhangs; "
              "0: wherever the fan becomes faster",
       .field = Convert<MachineRow>(
           [](MachineRow& row, const Value& value) {
             row.motion.fan_speedup_all = value.number == 0;
           },
           [](const MachineRow& row) {
             return Value{.number = row.motion.fan_speedup_all ? 0.0 : 1.0};
           }),
       .orca = {{"fan_speedup_overhangs"}},
       .needs = {&needs::kFanSpeedup}},
      {.key = "gcode_label_objects",
       .kind = Kind::kChoice,
       .standard = "disabled",
       .doc = "Marks in the G-code that name the printed copy, so that the printer can skip a "
              "failed one. octoprint: comments. firmware: EXCLUDE_OBJECT or M486 commands. 0 and 1 "
              "are older names of disabled and octoprint",
       .choices = {{"disabled", labels(ObjectLabels::kNone)},
                   {"octoprint", labels(ObjectLabels::kComments)},
                   {"firmware", labels(ObjectLabels::kFirmware)},
                   {"0", labels(ObjectLabels::kNone)},
                   {"1", labels(ObjectLabels::kComments)}},
       .field = Bind<&MachineRow::motion, &MachineMotion::labels>(),
       .orca = {{"gcode_label_objects", OrcaValue::kChoice}}},
      {.key = "arc_fitting",
       .kind = Kind::kChoice,
       .standard = "disabled",
       .doc = "Arcs (G2, G3) in place of chains of short moves that deviate from the arc by at "
              "most 0.025 mm. disabled: no arcs. emit_center: arcs with their centre (I, J)",
       .choices = {{"disabled", static_cast<int>(ArcFitting::kDisabled)},
                   {"emit_center", static_cast<int>(ArcFitting::kEmitCenter)}},
       .field = Bind<&MachineRow::motion, &MachineMotion::arc_fitting>(),
       .orca = {{"enable_arc_fitting", OrcaValue::kChoice}}},
      {.key = "gcode_resolution",
       .unit = "mm",
       .min = 0,
       .max = 1,
       .standard = "0.0125",
       .doc = "Largest deviation of the written moves from the planned paths; larger: fewer moves. "
              "0: all points are written",
       .field = Bind<&MachineRow::motion, &MachineMotion::resolution_nm>(),
       .orca = {{"resolution"}}},
      {.key = "printer_model",
       .kind = Kind::kText,
       .doc = "Name of the printer model, shown by printer hosts",
       .field = Bind<&MachineRow::motion, &MachineMotion::printer_model>(),
       .orca = {{"printer_model"}}},
  };
}

std::vector<SettingSpec> CustomGcode() {
  const auto gcode = [](std::string_view key, std::string_view standard, std::string_view doc,
                        Field field) {
    return SettingSpec{
        .key = key, .kind = Kind::kGcode, .standard = standard, .doc = doc, .field = field};
  };
  return {
      Orca({"machine_start_gcode", OrcaValue::kGcode},
           gcode("start_gcode", "G28 ; home all axes\\nG1 Z5 F5000 ; lift nozzle\\n",
                 "G-code before the first layer",
                 Bind<&MachineRow::motion, &MachineMotion::start_gcode>())),
      Orca({"machine_end_gcode", OrcaValue::kGcode},
           gcode("end_gcode",
                 "M104 S0 ; turn off temperature\\nG28 X0  ; home X axis\\nM84     ; disable "
                 "motors\\n",
                 "G-code after the last layer",
                 Bind<&MachineRow::motion, &MachineMotion::end_gcode>())),
      {.key = "start_filament_gcode",
       .kind = Kind::kGcode,
       .doc = "G-code of the filament, after start_gcode and heating",
       .list = List::kPerExtruder,
       .field = Bind<&ToolRow::start_filament_gcode>(),
       .orca = {{"filament_start_gcode", OrcaValue::kGcode}}},
      {.key = "end_filament_gcode",
       .kind = Kind::kGcode,
       .doc = "G-code of the filament, written before end_gcode",
       .list = List::kPerExtruder,
       .orca = {{"filament_end_gcode", OrcaValue::kGcode}}},
      Orca(
          {"before_layer_change_gcode", OrcaValue::kGcode},
          gcode(
              "before_layer_gcode", "",
              "G-code at each layer change, before the nozzle moves to the height of the new layer",
              Bind<&MachineRow::motion, &MachineMotion::before_layer_gcode>())),
      Orca({"layer_change_gcode", OrcaValue::kGcode},
           gcode("layer_gcode", "",
                 "G-code at each layer change, after the nozzle has moved to the height of the new "
                 "layer",
                 Bind<&MachineRow::motion, &MachineMotion::layer_gcode>())),
      {.key = "time_lapse_gcode",
       .kind = Kind::kGcode,
       .doc = "G-code that takes a time-lapse picture at each layer change, before layer_gcode; "
              "with gcode_flavor = bambu, after layer_gcode",
       .orca = {{"time_lapse_gcode", OrcaValue::kGcode}}},
      Orca({"printing_by_object_gcode", OrcaValue::kGcode},
           Needing({&needs::kObjectByObject},
                   gcode("between_objects_gcode", "",
                         "G-code between objects that are printed one after the other; the printer "
                         "executes it after the nozzle has risen above them",
                         Bind<&MachineRow::motion, &MachineMotion::between_objects_gcode>()))),
  };
}

std::vector<SettingSpec> Sequence() {
  return {
      {.key = "extruder",
       .kind = Kind::kInteger,
       .min = 0,
       .max = 255,
       .standard = "0",
       .doc = "Extruder that prints the job, counted from 1. If a nozzle or filament setting is a "
              "list, the item of this extruder applies. 0: the first extruder. All objects must "
              "use the same extruder",
       .own_scope = Scope::kRegion,
       .orca = {{"extruder"}}},
      {.key = "curr_bed_type",
       .kind = Kind::kText,
       .standard = "",
       .doc = "Type of the plate on the printer's bed, such as Textured PEI Plate; .gcode.3mf "
              "files contain it. In OrcaSlicer's settings it also selects the bed temperature"},
      {.key = "creation_time",
       .kind = Kind::kText,
       .standard = "",
       .doc = "Creation time of the job, such as 2026-11-25T10:37:01Z, for the placeholders "
              "timestamp, year, month, ... of custom G-code. Without such placeholders it has no "
              "effect"},
      {.key = "complete_objects",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Print each object completely before the next one begins; 0: print all objects "
              "together, layer by layer",
       .field = Bind<&MachineRow::plan, &JobPlanOptions::sequence,
                     &SequencePlanOptions::complete_objects>(),
       .orca = {{"print_sequence", OrcaValue::kChoice}}},
      {.key = "objects_may_overlap",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc =
           "Print copies that overlap, with a warning; 0: a job with overlapping copies is refused",
       .field = Bind<&MachineRow::plan, &JobPlanOptions::objects_may_overlap>()},
      {.key = "extruder_clearance_radius",
       .unit = "mm",
       .min = 0,
       .max = 1000,
       .standard = "20",
       .doc = "Radius around the nozzle that the print head needs; with complete_objects, copies "
              "are at least this distance apart",
       .field = Bind<&MachineRow::plan, &JobPlanOptions::sequence,
                     &SequencePlanOptions::clearance_radius_nm>(),
       .orca = {{"extruder_clearance_radius"}, {"extruder_clearance_max_radius"}},
       .needs = {&needs::kObjectByObject}},
      {.key = "extruder_clearance_height",
       .unit = "mm",
       .min = 0,
       .max = 1000,
       .standard = "20",
       .doc = "Height of the gantry above the nozzle tip. With complete_objects, only the copy "
              "that is printed last may be higher. extruder_clearance_height_to_lid also allows "
              "higher copies that the gantry does not reach",
       .field = Bind<&MachineRow::plan, &JobPlanOptions::sequence,
                     &SequencePlanOptions::clearance_height_nm>(),
       .orca = {{"extruder_clearance_height_to_rod"}},
       .needs = {&needs::kObjectByObject}},
      {.key = "extruder_clearance_height_to_lid",
       .unit = "mm",
       .min = 0,
       .max = 2000,
       .standard = "0",
       .doc = "Height of the printer's lid above the nozzle tip. With complete_objects, only the "
              "copy that is printed last may be higher. While later copies are printed, the "
              "gantry, a rod along x, must not reach copies above extruder_clearance_height. 0: "
              "the gantry covers the whole bed",
       .field = Bind<&MachineRow::plan, &JobPlanOptions::sequence,
                     &SequencePlanOptions::lid_height_nm>(),
       .orca = {{"extruder_clearance_height_to_lid"}},
       .needs = {&needs::kObjectByObject}},
      {.key = "extruder_clearance_dist_to_rod",
       .unit = "mm",
       .min = 0,
       .max = 1000,
       .standard = "0",
       .doc = "Distance in y from the nozzle to the far side of the gantry; used only with "
              "extruder_clearance_height_to_lid above 0",
       .field = Bind<&MachineRow::plan, &JobPlanOptions::sequence,
                     &SequencePlanOptions::gantry_reach_nm>(),
       .orca = {{"extruder_clearance_dist_to_rod"}},
       .needs = {&needs::kObjectByObject}},
      {.key = "nozzle_height",
       .unit = "mm",
       .min = 0,
       .max = 100,
       .standard = "0",
       .doc = "Height of the print head above the nozzle tip. With complete_objects, copies lower "
              "than this may be nearer to later copies than extruder_clearance_radius, but at "
              "least 2 mm apart. Automatic arrangement always keeps extruder_clearance_radius",
       .field = Bind<&MachineRow::plan, &JobPlanOptions::sequence,
                     &SequencePlanOptions::nozzle_height_nm>(),
       .orca = {{"nozzle_height"}},
       .needs = {&needs::kObjectByObject}},
  };
}

/// Returns the plate settings of all machines, with additional plate settings of FDM.
std::vector<SettingSpec> Plate() {
  std::vector<SettingSpec> settings = PlateSettings();
  settings.push_back({.key = "bed_exclude_area",
                      .kind = Kind::kAreas,
                      .unit = "mm",
                      .standard = "",
                      .doc = "Areas of the bed that parts, skirts, brims and travels avoid, such "
                             "as the area of a cutter: corners XxY in mm, separated by commas. "
                             "Each four corners that form a rectangle are one area; otherwise all "
                             "corners form one polygon. Custom G-code is not checked",
                      .field = Bind<&JobSlicingOptions::excluded>(),
                      .orca = {{"bed_exclude_area", OrcaValue::kPoints}}});
  for (SettingSpec& spec : settings) {
    if (spec.key == "max_print_height")
      spec.also = Bind<&MachineRow::motion, &MachineMotion::max_print_height_nm>();
    if (spec.key == "duplicate_distance")
      spec.doc =
          "Distance between copies that are arranged automatically; with complete_objects, the "
          "larger value of duplicate_distance and extruder_clearance_radius";
  }
  return settings;
}

}  // namespace

std::vector<SettingSpec> MachineSettings() {
  std::vector<SettingSpec> settings = Machine();
  const auto add = [&](std::vector<SettingSpec> more) {
    for (SettingSpec& spec : more) settings.push_back(std::move(spec));
  };
  add(AxisLimits<kX>({"machine_max_feedrate_x", "machine_max_acceleration_x", "machine_max_jerk_x"},
                     {"500", "9000", "10"}));
  add(AxisLimits<kY>({"machine_max_feedrate_y", "machine_max_acceleration_y", "machine_max_jerk_y"},
                     {"500", "9000", "10"}));
  add(AxisLimits<kZ>({"machine_max_feedrate_z", "machine_max_acceleration_z", "machine_max_jerk_z"},
                     {"12", "500", "0.2"}));
  add(AxisLimits<kE>({"machine_max_feedrate_e", "machine_max_acceleration_e", "machine_max_jerk_e"},
                     {"120", "10000", "2.5"}));
  add(Plate());
  add(WholeMachineLimits());
  add(CustomGcode());
  add(MonitoringSettings());
  add(Sequence());
  return settings;
}

}  // namespace slicefarm::config::fdm
