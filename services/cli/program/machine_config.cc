#include "services/cli/program/machine_config.h"

#include <algorithm>
#include <string>
#include <vector>

#include "common/config/projects/ini.h"
#include "common/config/projects/orca_settings.h"
#include "common/config/resolve.h"
#include "processes/fdm/model/fdm_settings.h"
#include "services/cli/console/files.h"
#include "services/cli/program/klipper_config.h"

namespace slicefarm::cli {
namespace {

/// Layer height in mm that is allowed for the finest nozzle.
constexpr std::string_view kFinestLayer = "0.05";

/// Settings that describe a machine.
constexpr std::string_view kMachineKeys[] = {"bed_shape",
                                             "max_print_height",
                                             "nozzle_diameter",
                                             "filament_diameter",
                                             "minimum_cruise_ratio",
                                             "square_corner_velocity",
                                             "jerk_limit",
                                             "nozzle_heating_rate",
                                             "bed_heating_rate",
                                             "retract_length",
                                             "retract_speed",
                                             "deretract_speed",
                                             "retract_restart_extra",
                                             "retract_lift",
                                             "use_volumetric_e",
                                             "z_offset"};

bool IsOfMachine(std::string_view key) {
  return key.starts_with("machine_max_") || key.starts_with("machine_min_") ||
         std::ranges::find(kMachineKeys, key) != std::end(kMachineKeys);
}

bool Has(const std::vector<config::Setting>& settings, std::string_view key) {
  return std::ranges::any_of(settings, [&](const config::Setting& s) { return s.key == key; });
}

bool QuotesSettings(std::string_view gcode) {
  return gcode.find("\n; prusaslicer_config = begin") != gcode.npos ||
         gcode.find("\n; machine_max_acceleration_x = ") != gcode.npos;
}

/// Reads settings in the names of PrusaSlicer.
absl::StatusOr<std::vector<config::Setting>> ReadSettings(std::string_view text) {
  auto given = config::ReadIni(text);
  if (given.ok() && Has(*given, "printable_area")) return config::FromOrca(*given, nullptr);
  return given;
}

}  // namespace

const motion::Firmware* FirmwareNamedIn(std::string_view gcode) {
  if (!QuotesSettings(gcode)) return nullptr;
  auto given = ReadSettings(gcode);
  if (!given.ok()) return nullptr;
  std::erase_if(*given, [](const config::Setting& s) { return s.key != "gcode_flavor"; });
  if (given->empty()) return nullptr;
  const auto resolved = config::Resolve(*given, Process::kFdm);
  if (!resolved.ok()) return nullptr;
  return &motion::FirmwareOf(MotionOf(FdmOf(resolved->settings)).flavor);
}

absl::StatusOr<motion::CheckSetup> SetupOfSettings(std::string_view text) {
  auto given = ReadSettings(text);
  if (!given.ok()) return given.status();
  std::erase_if(*given, [](const config::Setting& s) { return !IsOfMachine(s.key); });
  // No layers are made with this height, but the default height would be refused for fine nozzles.
  given->push_back({"layer_height", std::string(kFinestLayer)});
  given->push_back({"first_layer_height", std::string(kFinestLayer)});
  const auto resolved = config::Resolve(*given, Process::kFdm);
  if (!resolved.ok()) return resolved.status();
  const MotionOptions options = MotionOf(FdmOf(resolved->settings));
  motion::CheckSetup setup;
  setup.machine = motion::SetupOf(options);
  setup.nozzle_mm = options.tool().nozzle_diameter_mm;
  setup.filament_mm = options.tool().filament_diameter_mm;
  setup.z_offset_mm = options.z_offset_mm;
  if (Has(*given, "bed_shape")) setup.bed = resolved->settings.slicing.bed;
  if (Has(*given, "max_print_height"))
    setup.max_height_mm = ToMm(static_cast<double>(options.max_print_height_nm));
  return setup;
}

absl::StatusOr<MachineConfig> ReadMachine(const std::string& config_file, std::string_view gcode) {
  MachineConfig config;
  if (config_file.empty()) {
    if (QuotesSettings(gcode)) {
      // Other slicers also quote settings, in forms and ranges of their own.
      if (const auto quoted = SetupOfSettings(gcode); quoted.ok())
        return MachineConfig{*quoted, "gcode"};
    }
    const auto standard = SetupOfSettings("z_offset = 0\n");
    if (!standard.ok()) return standard.status();
    return MachineConfig{*standard, "defaults"};
  }
  const auto text = ReadText(config_file, kMaxConfigBytes);
  if (!text.ok()) return text.status();
  const auto setup = IsKlipperConfig(*text) ? ReadKlipperConfig(*text) : SetupOfSettings(*text);
  if (!setup.ok()) return InFile(config_file, setup.status());
  return MachineConfig{*setup, config_file};
}

}  // namespace slicefarm::cli
