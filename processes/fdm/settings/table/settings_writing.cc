#include "processes/fdm/settings/table/needs.h"
#include "processes/fdm/settings/table/settings_sections.h"

namespace slicefarm::config::fdm {
namespace {

SettingSpec WritingFlag(std::string_view key, std::string_view standard, std::string_view doc,
                        Field field) {
  return {.key = key, .kind = Kind::kFlag, .standard = standard, .doc = doc, .field = field};
}

std::vector<SettingSpec> WritingWords() {
  return {
      Orca({"use_relative_e_distances"},
           WritingFlag(
               "use_relative_e_distances", "1",
               "Write the extrusion of each move by itself (relative E), so that G-code can be cut "
               "and joined anywhere; 0: write the sum since the start (absolute E). Default in "
               "PrusaSlicer: 0",
               Bind<&MachineRow::motion, &MachineMotion::writing, &WritingOptions::relative_e>())),
      WritingFlag(
          "use_volumetric_e", "0",
          "Write extrusion as volume in mm3 instead of length in mm; start_gcode must tell the "
          "machine the filament diameter (M200)",
          Bind<&MachineRow::motion, &MachineMotion::writing, &WritingOptions::volumetric_e>()),
      Orca({"use_firmware_retraction"},
           WritingFlag(
               "use_firmware_retraction", "0",
               "Write retractions as G10 and G11; the firmware sets their length and speed. Then "
               "retract_length, retract_speed and deretract_speed affect only the estimated time",
               Bind<&MachineRow::motion, &MachineMotion::writing,
                    &WritingOptions::firmware_retraction>())),
      Orca({"gcode_comments"},
           WritingFlag(
               "gcode_comments", "0",
               "Add a comment to each move that names the purpose of the move",
               Bind<&MachineRow::motion, &MachineMotion::writing, &WritingOptions::comments>())),
      WritingFlag("binary_gcode", "0", "Write binary G-code (.bgcode), which Prusa printers read",
                  Bind<&MachineRow::motion, &MachineMotion::writing, &WritingOptions::binary>()),
      WritingFlag(
          "gcode_3mf", "0",
          "Put the G-code into a .gcode.3mf archive with pictures and data of the plate, "
          "which Bambu Lab's printers read over the network. binary_gcode then has no effect",
          Bind<&MachineRow::motion, &MachineMotion::writing, &WritingOptions::archive>()),
      {.key = "gcode_substitutions",
       .kind = Kind::kSubstitutions,
       .doc = "Replacements in the text of the G-code, layer by layer: pattern, replacement, flags "
              "and notes, in quotes, separated by semicolons. Flags: r: regular expression. i: "
              "ignore case. w: whole words. s: a dot also matches a line end",
       .field =
           Bind<&MachineRow::motion, &MachineMotion::writing, &WritingOptions::substitutions>()},
      {.key = "output_filename_format",
       .kind = Kind::kText,
       .standard = "[input_filename_base].gcode",
       .doc = "Name of the output file if the job gives no name; may contain the placeholders of "
              "custom G-code, such as [layer_height]",
       .field = Bind<&MachineRow::motion, &MachineMotion::writing, &WritingOptions::file_name>(),
       .orca = {{"filename_format", OrcaValue::kGcode}}},
  };
}

std::vector<SettingSpec> AroundBeads() {
  const auto role = [](std::string_view key, std::string_view doc) {
    return SettingSpec{.key = key, .kind = Kind::kGcode, .doc = doc};
  };
  SettingSpec machine =
      role("change_extrusion_role_gcode",
           "G-code before the first line of another feature; {extrusion_role} and "
           "{last_extrusion_role} are Perimeter, ExternalPerimeter, InternalInfill, ... At the "
           "start of a layer, last_extrusion_role is empty");
  machine.field = Bind<&MachineRow::motion, &MachineMotion::role_gcode>();
  SettingSpec filament = role("filament_change_extrusion_role_gcode",
                              "G-code of the filament, after change_extrusion_role_gcode");
  filament.list = List::kPerExtruder;
  return {
      Orca({"change_extrusion_role_gcode", OrcaValue::kGcode}, machine),
      Orca({"filament_change_extrusion_role_gcode", OrcaValue::kGcode}, filament),
      Orca({"process_change_extrusion_role_gcode", OrcaValue::kGcode},
           role("process_change_extrusion_role_gcode",
                "G-code of the process, after filament_change_extrusion_role_gcode")),
      {.key = "file_start_gcode",
       .kind = Kind::kGcode,
       .doc = "Text at the very top of the file, such as data that the firmware reads from the "
              "first lines; binary G-code has none",
       .field = Bind<&MachineRow::motion, &MachineMotion::file_start_gcode>(),
       .orca = {{"file_start_gcode", OrcaValue::kGcode}}},
      {.key = "time_cost",
       .unit = "money/h",
       .min = 0,
       .max = 1e6,
       .standard = "0",
       .doc = "Cost of the printer per hour, added to the cost of the filament in the report",
       .field = Bind<&MachineRow::motion, &MachineMotion::cost_per_hour>(),
       .orca = {{"time_cost"}}},
  };
}

std::vector<SettingSpec> AtHeights() {
  const auto gcode = [](std::string_view key, std::string_view standard, std::string_view doc,
                        Field field) {
    return SettingSpec{
        .key = key, .kind = Kind::kGcode, .standard = standard, .doc = doc, .field = field};
  };
  return {
      {.key = "custom_gcode_per_print_z",
       .kind = Kind::kHeightCode,
       .doc =
           "Actions at heights of the print, as a list in JSON. Each action has a height z in mm, "
           "a type and a text. color_change: the text is the colour. pause: the message on the "
           "display. template, custom: the G-code. retract_length: the length of retractions "
           "from this height on",
       .field = Bind<&MachineRow::motion, &MachineMotion::writing, &WritingOptions::height_code>(),
       .orca = {{"custom_gcode_per_print_z", OrcaValue::kWhole}},
       .needs = {&needs::kLayerByLayer}},
      gcode("color_change_gcode", "M600", "G-code of each color_change in custom_gcode_per_print_z",
            Bind<&MachineRow::motion, &MachineMotion::writing,
                 &WritingOptions::color_change_gcode>()),
      Orca({"machine_pause_gcode", OrcaValue::kGcode},
           gcode(
               "pause_print_gcode", "M601", "G-code of each pause in custom_gcode_per_print_z",
               Bind<&MachineRow::motion, &MachineMotion::writing, &WritingOptions::pause_gcode>())),
      Orca({"template_custom_gcode", OrcaValue::kGcode},
           gcode("template_custom_gcode", "", "G-code of each template in custom_gcode_per_print_z",
                 Bind<&MachineRow::motion, &MachineMotion::writing,
                      &WritingOptions::template_gcode>())),
  };
}

}  // namespace

std::vector<SettingSpec> WritingSettings() {
  std::vector<SettingSpec> settings = WritingWords();
  for (auto part : {AroundBeads(), AtHeights()})
    for (SettingSpec& spec : part) settings.push_back(std::move(spec));
  return settings;
}

}  // namespace slicefarm::config::fdm
