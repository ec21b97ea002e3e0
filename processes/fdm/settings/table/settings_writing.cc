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
               "Each move says how much filament it pushes, not how much was pushed before it "
               "as well. PrusaSlicer's standard is 0; programs of relative moves can be cut and "
               "joined anywhere",
               Bind<&MachineRow::motion, &MachineMotion::writing, &WritingOptions::relative_e>())),
      WritingFlag(
          "use_volumetric_e", "0",
          "Filament in mm3, not in mm: the machine has to know its diameter (M200 in "
          "start_gcode)",
          Bind<&MachineRow::motion, &MachineMotion::writing, &WritingOptions::volumetric_e>()),
      Orca({"use_firmware_retraction"},
           WritingFlag("use_firmware_retraction", "0",
                       "Retractions by G10 and G11, as long and as fast as the machine is set to; "
                       "retract_length and its speeds are left for times",
                       Bind<&MachineRow::motion, &MachineMotion::writing,
                            &WritingOptions::firmware_retraction>())),
      Orca({"gcode_comments"},
           WritingFlag(
               "gcode_comments", "0", "Each move says in a comment what it is for",
               Bind<&MachineRow::motion, &MachineMotion::writing, &WritingOptions::comments>())),
      WritingFlag("binary_gcode", "0",
                  "The file is binary G-code (.bgcode), as Prusa's printers read",
                  Bind<&MachineRow::motion, &MachineMotion::writing, &WritingOptions::binary>()),
      {.key = "gcode_substitutions",
       .kind = Kind::kSubstitutions,
       .doc = "Texts of the G-code that others take the place of, layer by layer: pattern, "
              "replacement, flags (r: regular expression, i: whatever the case, w: whole words, s: "
              "a dot is a line end as well) and notes, in quotes, by semicolons",
       .field =
           Bind<&MachineRow::motion, &MachineMotion::writing, &WritingOptions::substitutions>()},
      {.key = "output_filename_format",
       .kind = Kind::kText,
       .standard = "[input_filename_base].gcode",
       .doc = "Name of the file where none is given; may name what templates of G-code may",
       .field = Bind<&MachineRow::motion, &MachineMotion::writing, &WritingOptions::file_name>(),
       .orca = {{"filename_format", OrcaValue::kGcode}}},
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
       .doc = "What is done at heights of the print: z in mm, type (color_change, pause, template, "
              "custom) and text (colour, message, G-code)",
       .field = Bind<&MachineRow::motion, &MachineMotion::writing, &WritingOptions::height_code>(),
       .orca = {{"custom_gcode_per_print_z", OrcaValue::kWhole}}},
      gcode("color_change_gcode", "M600", "G-code of a change of colour",
            Bind<&MachineRow::motion, &MachineMotion::writing,
                 &WritingOptions::color_change_gcode>()),
      Orca({"machine_pause_gcode", OrcaValue::kGcode},
           gcode(
               "pause_print_gcode", "M601", "G-code of a pause",
               Bind<&MachineRow::motion, &MachineMotion::writing, &WritingOptions::pause_gcode>())),
      Orca({"template_custom_gcode", OrcaValue::kGcode},
           gcode("template_custom_gcode", "", "G-code at heights of type template",
                 Bind<&MachineRow::motion, &MachineMotion::writing,
                      &WritingOptions::template_gcode>())),
  };
}

}  // namespace

std::vector<SettingSpec> WritingSettings() {
  std::vector<SettingSpec> settings = WritingWords();
  for (SettingSpec& spec : AtHeights()) settings.push_back(std::move(spec));
  return settings;
}

}  // namespace slicefarm::config::fdm
