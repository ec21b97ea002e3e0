#include "common/config/table/shared_settings.h"
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
      Limit(keys[0], "mm/s", 0.001, 100'000, standards[0], "Speed limit of this axis",
            Bind<&MachineRow::motion, &MachineMotion::limits, &MachineLimits::max_feedrate_mm_s,
                 kAxis>()),
      Limit(keys[1], "mm/s2", 0.001, 1e6, standards[1], "Acceleration limit of this axis",
            Bind<&MachineRow::motion, &MachineMotion::limits,
                 &MachineLimits::max_acceleration_mm_s2, kAxis>()),
      Limit(keys[2], "mm/s", 0, 100'000, standards[2],
            "Jump of speed that this axis allows at corners (Marlin's classic jerk)",
            Bind<&MachineRow::motion, &MachineMotion::limits, &MachineLimits::max_jerk_mm_s,
                 kAxis>()),
  };
}

std::vector<SettingSpec> WholeMachineLimits() {
  return {
      Orca({"machine_max_acceleration_extruding"},
           Limit("machine_max_acceleration_extruding", "mm/s2", 0, 1e6, "1500",
                 "Acceleration limit while extruding; 0: none",
                 Bind<&MachineRow::motion, &MachineMotion::limits,
                      &MachineLimits::max_acceleration_extruding_mm_s2>())),
      Orca({"machine_max_acceleration_retracting"},
           Limit("machine_max_acceleration_retracting", "mm/s2", 0, 1e6, "1500",
                 "Acceleration limit of retractions; 0: none",
                 Bind<&MachineRow::motion, &MachineMotion::limits,
                      &MachineLimits::max_acceleration_retracting_mm_s2>())),
      Orca({"machine_max_acceleration_travel"},
           Limit("machine_max_acceleration_travel", "mm/s2", 0, 1e6, "1500",
                 "Acceleration limit of travel; 0: none",
                 Bind<&MachineRow::motion, &MachineMotion::limits,
                      &MachineLimits::max_acceleration_travel_mm_s2>())),
      Orca({"machine_max_junction_deviation"},
           Limit("machine_max_junction_deviation", "mm", 0, 10, "0",
                 "Marlin's junction deviation; 0: the firmware uses classic jerk",
                 Bind<&MachineRow::motion, &MachineMotion::limits,
                      &MachineLimits::junction_deviation_mm>())),
      Limit("square_corner_velocity", "mm/s", 0, 1000, "5", "Klipper's speed through right angles",
            Bind<&MachineRow::motion, &MachineMotion::limits,
                 &MachineLimits::square_corner_velocity_mm_s>()),
      Limit("minimum_cruise_ratio", "", 0, 0.99, "0.5",
            "Klipper's least share of a short move at its top speed",
            Bind<&MachineRow::motion, &MachineMotion::limits,
                 &MachineLimits::minimum_cruise_ratio>()),
      Orca({"machine_min_extruding_rate"},
           Limit("machine_min_extruding_rate", "mm/s", 0, 1000, "0", "No bead is slower",
                 Bind<&MachineRow::motion, &MachineMotion::limits,
                      &MachineLimits::min_extruding_rate_mm_s>())),
      Orca({"machine_min_travel_rate"},
           Limit("machine_min_travel_rate", "mm/s", 0, 1000, "0", "No travel is slower",
                 Bind<&MachineRow::motion, &MachineMotion::limits,
                      &MachineLimits::min_travel_rate_mm_s>())),
      Limit("jerk_limit", "mm/s3", 1, 1e8, "100000",
            "How fast acceleration may change on machines that follow the host's own planner",
            Bind<&MachineRow::motion, &MachineMotion::limits, &MachineLimits::jerk_mm_s3>()),
      {.key = "silent_mode",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc =
           "The machine has a silent mode (Marlin): the second values of its limits say how long "
           "the print takes in it"},
      {.key = "machine_limits_usage",
       .kind = Kind::kChoice,
       .standard = "time_estimate_only",
       .doc = "Whether the limits are written to the G-code too, or only reckoned with; "
              "ignore: all of them are those of no setting",
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
       .doc = "The firmware that the G-code is for",
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
       .doc = "Shares of the materials that a mixing extruder takes in, by place on the plate",
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
       .doc = "How fast the nozzle heats up, for times; 0: waiting for it counts as no time",
       .field = Bind<&MachineRow::motion, &MachineMotion::nozzle_heating_c_s>()},
      {.key = "bed_heating_rate",
       .unit = "C/s",
       .min = 0,
       .max = 1000,
       .standard = "0",
       .doc = "How fast the bed heats up, for times; 0: waiting for it counts as no time",
       .field = Bind<&MachineRow::motion, &MachineMotion::bed_heating_c_s>()},
      {.key = "autoemit_temperature_commands",
       .kind = Kind::kFlag,
       .standard = "1",
       .doc = "Heats around start_gcode what it does not heat by itself (M104, M109, M140, M190, "
              "M141, "
              "M191)",
       .field = Bind<&MachineRow::motion, &MachineMotion::emit_temperatures>()},
      {.key = "z_offset",
       .unit = "mm",
       .min = -100,
       .max = 100,
       .standard = "0",
       .doc = "Added to all heights in the G-code",
       .field = Bind<&MachineRow::motion, &MachineMotion::z_offset_mm>(),
       .orca = {{"z_offset"}}},
      {.key = "extruder_offset",
       .kind = Kind::kPoint,
       .unit = "mm",
       .standard = "0x0",
       .doc = "Where the nozzle is in the head: all places in the G-code lie so much farther back",
       .list = List::kPerExtruder,
       .field = Bind<&ToolRow::offset>(),
       .orca = {{"extruder_offset"}}},
      {.key = "remaining_times",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Tells the printer before each layer how much is done (M73)",
       .field = Bind<&MachineRow::motion, &MachineMotion::progress>()},
      {.key = "gcode_label_objects",
       .kind = Kind::kChoice,
       .standard = "disabled",
       .doc = "Whether the G-code says which copy it prints, so that a printer can give up one",
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
       .doc =
           "Writes curves as arcs (G2, G3) where they are within 0.025 mm; emit_center: by their "
           "centres",
       .choices = {{"disabled", static_cast<int>(ArcFitting::kDisabled)},
                   {"emit_center", static_cast<int>(ArcFitting::kEmitCenter)}},
       .field = Bind<&MachineRow::motion, &MachineMotion::arc_fitting>(),
       .orca = {{"enable_arc_fitting", OrcaValue::kChoice}}},
      {.key = "gcode_resolution",
       .unit = "mm",
       .min = 0,
       .max = 1,
       .standard = "0.0125",
       .doc =
           "How far straight moves may deviate from the curves that they stand for; 0: all points "
           "of paths are written",
       .field = Bind<&MachineRow::motion, &MachineMotion::resolution_nm>(),
       .orca = {{"resolution"}}},
      {.key = "printer_model",
       .kind = Kind::kText,
       .doc = "Name of the printer, for printer hosts",
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
       .doc = "G-code of the filament, after start_gcode, when all is hot",
       .list = List::kPerExtruder,
       .field = Bind<&ToolRow::start_filament_gcode>(),
       .orca = {{"filament_start_gcode", OrcaValue::kGcode}}},
      {.key = "end_filament_gcode",
       .kind = Kind::kGcode,
       .doc = "G-code of the filament, before end_gcode",
       .list = List::kPerExtruder,
       .orca = {{"filament_end_gcode", OrcaValue::kGcode}}},
      Orca({"before_layer_change_gcode", OrcaValue::kGcode},
           gcode("before_layer_gcode", "", "G-code before each layer's move up",
                 Bind<&MachineRow::motion, &MachineMotion::before_layer_gcode>())),
      Orca({"layer_change_gcode", OrcaValue::kGcode},
           gcode("layer_gcode", "", "G-code after each layer's move up",
                 Bind<&MachineRow::motion, &MachineMotion::layer_gcode>())),
      {.key = "time_lapse_gcode",
       .kind = Kind::kGcode,
       .doc =
           "G-code that takes a picture, at each layer: before layer_gcode, on a machine of Bambu "
           "Lab's after it",
       .orca = {{"time_lapse_gcode", OrcaValue::kGcode}}},
      gcode("between_objects_gcode", "",
            "G-code between objects that are printed one after the other, high above them",
            Bind<&MachineRow::motion, &MachineMotion::between_objects_gcode>()),
  };
}

std::vector<SettingSpec> Sequence() {
  return {
      {.key = "extruder",
       .kind = Kind::kInteger,
       .min = 0,
       .max = 255,
       .standard = "0",
       .doc = "Which extruder prints it, and so whose nozzle and filament count: that item of each "
              "list; 0: the first. All that is printed must have the same",
       .own_scope = Scope::kRegion,
       .orca = {{"extruder"}}},
      {.key = "creation_time",
       .kind = Kind::kText,
       .standard = "",
       .doc =
           "When the job was made, as 2026-11-25T10:37:01Z: timestamp, year, month, ... of G-code "
           "templates. Counts only if they name it"},
      {.key = "complete_objects",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Prints one copy after the other, each as a whole",
       .field = Bind<&MachineRow::plan, &JobPlanOptions::sequence,
                     &SequencePlanOptions::complete_objects>(),
       .orca = {{"print_sequence", OrcaValue::kChoice}}},
      {.key = "objects_may_overlap",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Prints copies that share room through one another, and warns of it, instead of "
              "refusing the job",
       .field = Bind<&MachineRow::plan, &JobPlanOptions::objects_may_overlap>()},
      {.key = "extruder_clearance_radius",
       .unit = "mm",
       .min = 0,
       .max = 1000,
       .standard = "20",
       .doc = "Room that the head takes around the nozzle: copies that are printed one after the "
              "other stand so far apart",
       .field = Bind<&MachineRow::plan, &JobPlanOptions::sequence,
                     &SequencePlanOptions::clearance_radius_nm>(),
       .orca = {{"extruder_clearance_radius"}, {"extruder_clearance_max_radius"}}},
      {.key = "extruder_clearance_height",
       .unit = "mm",
       .min = 0,
       .max = 1000,
       .standard = "20",
       .doc = "Height of the gantry over the nozzle: of the copies that are printed one after the "
              "other only the last may be taller",
       .field = Bind<&MachineRow::plan, &JobPlanOptions::sequence,
                     &SequencePlanOptions::clearance_height_nm>(),
       .orca = {{"extruder_clearance_height_to_rod"}}},
  };
}

/// Returns the plate settings of all machines, with additional plate settings of FDM.
std::vector<SettingSpec> Plate() {
  std::vector<SettingSpec> settings = PlateSettings();
  settings.push_back(
      {.key = "bed_exclude_area",
       .kind = Kind::kAreas,
       .unit = "mm",
       .standard = "",
       .doc =
           "Areas of the bed that parts, skirts, brims and travel keep out of, such as that of a "
           "cutter: corners XxY, by commas; each four that are a rectangle are one area, else "
           "all corners are one polygon. G-code of the settings is not looked at",
       .field = Bind<&JobSlicingOptions::excluded>(),
       .orca = {{"bed_exclude_area", OrcaValue::kPoints}}});
  for (SettingSpec& spec : settings) {
    if (spec.key == "max_print_height")
      spec.also = Bind<&MachineRow::motion, &MachineMotion::max_print_height_nm>();
    if (spec.key == "duplicate_distance")
      spec.doc =
          "Distance between copies that are arranged; at least extruder_clearance_radius with "
          "complete_objects";
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
  add(Sequence());
  return settings;
}

}  // namespace slicefarm::config::fdm
