#pragma once

#include <string>
#include <utility>
#include <vector>

#include "common/config/presets/read_presets.h"

namespace slicefarm::config::presets {

/// Returns files with these paths and texts.
inline std::vector<PresetFile> Files(
    const std::vector<std::pair<std::string, std::string>>& texts) {
  std::vector<PresetFile> files;
  for (const auto& [path, text] : texts) files.push_back({path, text});
  return files;
}

/// Returns the only listed preset of this name, or nullptr.
inline const Preset* Only(const PresetSet& set, PresetKind kind, std::string_view name) {
  const std::vector<const Preset*> found = set.Named(kind, name);
  return found.size() == 1 ? found.front() : nullptr;
}

/// Returns a vendor of two printers as OrcaSlicer has it in its folder, with filaments that inherit
/// from another vendor's.
inline std::vector<PresetFile> OrcaFolder() {
  return Files({
      {"system/OrcaFilamentLibrary.json",
       R"({"filament_list": [{"name": "lib_pla", "sub_path": "filament/lib_pla.json"},
                             {"name": "Generic PLA @System", "sub_path": "filament/any.json"}],
           "machine_list": []})"},
      {"system/OrcaFilamentLibrary/filament/lib_pla.json",
       R"({"type": "filament", "name": "lib_pla", "instantiation": "false",
           "nozzle_temperature": ["215"], "filament_density": ["1.24"]})"},
      {"system/OrcaFilamentLibrary/filament/any.json",
       R"({"type": "filament", "name": "Generic PLA @System", "instantiation": "true",
           "inherits": "lib_pla", "compatible_printers": []})"},
      {"system/Acme.json",
       R"({"name": "Acme", "version": "1.0",
           "machine_model_list": [{"name": "Acme One", "sub_path": "machine/model.json"}],
           "machine_list": [{"name": "base", "sub_path": "machine/base.json"},
                            {"name": "Acme One 0.4", "sub_path": "machine/one4.json"},
                            {"name": "Acme One 0.6", "sub_path": "machine/one6.json"}],
           "process_list": [{"name": "fdm", "sub_path": "process/fdm.json"},
                            {"name": "0.20mm @One", "sub_path": "process/p20.json"},
                            {"name": "0.30mm @One 0.6", "sub_path": "process/p30.json"}],
           "filament_list": [{"name": "Acme PLA @One", "sub_path": "filament/pla.json"}]})"},
      {"system/Acme/machine/model.json",
       R"({"type": "machine_model", "name": "Acme One", "default_bed_type": "Textured PEI Plate",
           "default_materials": "Acme PLA @One;Generic PLA @System"})"},
      {"system/Acme/machine/base.json",
       R"({"type": "machine", "name": "base", "instantiation": "false", "gcode_flavor": "klipper",
           "printer_model": "Acme One", "nozzle_diameter": ["0.4"],
           "printable_area": ["0x0", "220x0", "220x220", "0x220"]})"},
      {"system/Acme/machine/one4.json",
       R"({"type": "machine", "name": "Acme One 0.4", "instantiation": "true", "inherits": "base",
           "default_print_profile": "0.20mm @One"})"},
      {"system/Acme/machine/one6.json",
       R"({"type": "machine", "name": "Acme One 0.6", "instantiation": "true", "inherits": "base",
           "nozzle_diameter": ["0.6"], "renamed_from": "Acme Uno 0.6"})"},
      {"system/Acme/process/fdm.json",
       R"({"type": "process", "name": "fdm", "instantiation": "false", "layer_height": "0.2",
           "wall_loops": "4", "outer_wall_speed": "60"})"},
      {"system/Acme/process/p20.json",
       R"({"type": "process", "name": "0.20mm @One", "instantiation": "true", "inherits": "fdm",
           "nozzle_temperature": "999", "compatible_printers": ["Acme One 0.4"]})"},
      {"system/Acme/process/p30.json",
       R"({"type": "process", "name": "0.30mm @One 0.6", "instantiation": "true", "inherits": "fdm",
           "layer_height": "0.3", "compatible_printers_condition": "nozzle_diameter[0]==0.6"})"},
      {"system/Acme/process/unlisted.json",
       R"({"type": "process", "name": "SettingValues", "instantiation": "true", "inherits": "fdm"})"},
      {"system/Acme/filament/pla.json",
       R"({"type": "filament", "name": "Acme PLA @One", "instantiation": "true",
           "inherits": "lib_pla", "nozzle_temperature": ["225", "230"],
           "textured_plate_temp": ["55"], "hot_plate_temp": ["70"],
           "compatible_printers": ["Acme One 0.4", "Acme One 0.6"]})"},
      {"user/17/machine/Acme Two.json",
       R"({"name": "Acme Two", "from": "User", "inherits": "Acme One 0.6",
           "default_print_profile": "0.20mm @One"})"},
      {"user/17/process/Two.json",
       R"({"name": "0.20mm @Two", "from": "User", "inherits": "0.20mm @One",
           "compatible_printers": ["Acme Two"]})"},
      {"user/17/machine/My One.json",
       R"({"name": "My One", "from": "User", "inherits": "Acme One 0.4",
           "printer_settings_id": "My One", "machine_start_gcode": "G28\nPRIME"})"},
      {"user/17/process/Fast.json",
       R"({"name": "Fast", "from": "User", "inherits": "0.20mm @One",
           "print_settings_id": "Fast", "outer_wall_speed": "120"})"},
  });
}

}  // namespace slicefarm::config::presets
