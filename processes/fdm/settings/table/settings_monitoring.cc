#include "common/model/limits.h"
#include "processes/fdm/settings/table/needs.h"
#include "processes/fdm/settings/table/settings_sections.h"

namespace slicefarm::config::fdm {
namespace {

std::vector<SettingSpec> WrappingDetection() {
  return {
      {.key = "enable_wrapping_detection",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Let the printer check in the first layers for filament that clumps at the nozzle. "
              "Parts, skirts, brims and travels keep off wrapping_exclude_area",
       .orca = {{"enable_wrapping_detection"}},
       .needs = {&needs::kWrappingArea}},
      {.key = "wrapping_detection_layers",
       .kind = Kind::kInteger,
       .unit = "layers",
       .min = 0,
       .max = limits::kMaxLayers,
       .standard = "20",
       .doc = "Number of layers, counted from the bed, after which wrapping_detection_gcode is run",
       .own_scope = Scope::kJob,
       .orca = {{"wrapping_detection_layers"}},
       .needs = {&needs::kWrappingDetection, &needs::kWrappingArea}},
      {.key = "wrapping_detection_gcode",
       .kind = Kind::kGcode,
       .doc =
           "G-code that checks for clumps, after each of the first wrapping_detection_layers "
           "layers and before the layer_gcode of the next one; layer_num is the number of layers "
           "that are printed",
       .orca = {{"wrapping_detection_gcode", OrcaValue::kGcode}},
       .needs = {&needs::kWrappingDetection, &needs::kWrappingArea}},
      {.key = "wrapping_exclude_area",
       .kind = Kind::kAreas,
       .unit = "mm",
       .standard = "",
       .doc = "Area of the bed where the printer checks for clumps, in the form of "
              "bed_exclude_area; empty: no check",
       .field = Bind<&JobSlicingOptions::wrapping>(),
       .orca = {{"wrapping_exclude_area", OrcaValue::kPoints}},
       .needs = {&needs::kWrappingDetection}},
  };
}

std::vector<SettingSpec> BedMass() {
  return {
      {.key = "machine_max_force_y",
       .unit = "N",
       .min = 0,
       .max = 1e6,
       .standard = "0",
       .doc =
           "Greatest force of the y axis on a bed that moves. In layer_gcode, "
           "curr_y_acceleration_limit is then the acceleration of the bed with the print so far, "
           "and at most machine_max_acceleration_y. 0: machine_max_acceleration_y",
       .field = Bind<&MachineRow::motion, &MachineMotion::bed_motor, &BedMotor::force_n>(),
       .orca = {{"machine_max_force_Y"}}},
      {.key = "machine_bed_mass_y",
       .unit = "g",
       .min = 0,
       .max = 1e7,
       .standard = "0",
       .doc = "Mass that the y axis moves without a print, for machine_max_force_y",
       .field = Bind<&MachineRow::motion, &MachineMotion::bed_motor, &BedMotor::bed_mass_g>(),
       .orca = {{"machine_bed_mass_Y"}},
       .needs = {&needs::kForceY}},
      {.key = "machine_max_printed_mass",
       .unit = "g",
       .min = 0,
       .max = 1e7,
       .standard = "0",
       .doc = "Greatest mass of a print; a heavier one is refused. 0: no limit",
       .field = Bind<&MachineRow::motion, &MachineMotion::bed_motor, &BedMotor::max_print_mass_g>(),
       .orca = {{"machine_max_printed_mass"}}},
  };
}

std::vector<SettingSpec> Camera() {
  return {
      {.key = "timelapse_type",
       .kind = Kind::kInteger,
       .min = 0,
       .max = 1,
       .standard = "0",
       .doc =
           "Value for time_lapse_gcode. 0: a picture over the print. 1: the head first moves off "
           "the print (smooth). There is no tower to wipe the nozzle on afterwards",
       .own_scope = Scope::kJob,
       .orca = {{"timelapse_type"}}},
      {.key = "farthest_point_timelapse",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Value for time_lapse_gcode of Bambu Lab's machines: take pictures where the head is "
              "far from the camera, without a lift",
       .own_scope = Scope::kJob,
       .orca = {{"farthest_point_timelapse"}},
       .needs = {&needs::kTraditionalTimelapse}},
      {.key = "cooling_filter_enabled",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Value for G-code of Bambu Lab's machines: cool the chamber through its filter",
       .own_scope = Scope::kJob,
       .orca = {{"cooling_filter_enabled"}}},
  };
}

}  // namespace

std::vector<SettingSpec> MonitoringSettings() {
  std::vector<SettingSpec> settings = WrappingDetection();
  for (auto part : {BedMass(), Camera()})
    for (SettingSpec& spec : part) settings.push_back(std::move(spec));
  return settings;
}

}  // namespace slicefarm::config::fdm
