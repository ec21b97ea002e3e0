#include "services/cli/commands/gcode_options.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <utility>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "services/cli/console/choice_option.h"
#include "services/cli/console/files.h"
#include "services/cli/job/job_options.h"

namespace slicefarm::cli {
namespace {

constexpr int64_t kMaxGcodeBytes = int64_t{2} << 30;
constexpr std::string_view kFlavors = "klipper, marlin, rrf, prusabuddy, bambu, grbl or jerk";

}  // namespace

void AddPlateOption(CLI::App& app, int& plate) {
  app.add_option("--plate", plate,
                 "Plate of a .gcode.3mf archive with several plates, counted from 1")
      ->check(InRange(1, static_cast<int>(limits::kMaxProjectPlates)))
      ->type_name("N");
}

void AddGcodeOptions(CLI::App& app, GcodeOptions& options) {
  AddPlateOption(app, options.plate);
  app.add_option("GCODE", options.gcode, "G-code file of any slicer: text, .bgcode or .gcode.3mf")
      ->required();
  app.add_option("--flavor", options.flavor,
                 fmt::format("Firmware of the machine: {}. rrf: RepRapFirmware. jerk: no firmware, "
                             "but slicefarm's own motion planner. Default: the gcode_flavor of the "
                             "settings in the G-code file",
                             kFlavors))
      ->type_name("NAME");
  app.add_option(
         "-c,--config", options.config,
         "Machine limits: PrusaSlicer config.ini (machine_max_*, bed_shape, ...) or Klipper's "
         "printer.cfg. Default: the settings in the G-code file, otherwise PrusaSlicer's defaults")
      ->type_name("FILE");
}

absl::Status UnknownFlavor(std::string_view flavor) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                   fmt::format("--flavor {}: must be {}", flavor, kFlavors));
}

absl::StatusOr<GcodeFile> ReadGcode(const GcodeOptions& options) {
  GcodeFile file;
  if (!options.flavor.empty()) {
    file.firmware = motion::FindFirmware(options.flavor);
    if (file.firmware == nullptr) return UnknownFlavor(options.flavor);
  }
  auto gcode = ReadText(options.gcode, kMaxGcodeBytes, options.plate);
  if (!gcode.ok()) return gcode.status();
  file.gcode = *std::move(gcode);
  if (file.firmware == nullptr) file.firmware = FirmwareNamedIn(file.gcode);
  if (file.firmware == nullptr)
    return Malformed(fmt::format("{} does not name its firmware (gcode_flavor): add --flavor {}",
                                 options.gcode, kFlavors));
  auto machine = ReadMachine(options.config, file.gcode);
  if (!machine.ok()) return machine.status();
  file.machine = *std::move(machine);
  return file;
}

}  // namespace slicefarm::cli
