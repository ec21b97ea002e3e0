#include "services/cli/commands/gcode_options.h"

#include <fmt/core.h>

#include <utility>

#include "common/base/error.h"
#include "services/cli/files.h"

namespace slicefarm::cli {
namespace {

constexpr int64_t kMaxGcodeBytes = int64_t{2} << 30;

}  // namespace

void AddGcodeOptions(CLI::App& app, GcodeOptions& options) {
  app.add_option("GCODE", options.gcode, "G-code of any slicer")->required();
  app.add_option("--flavor", options.flavor,
                 "Firmware of the machine: klipper, marlin, rrf (RepRapFirmware), or grbl")
      ->required()
      ->type_name("NAME");
  app.add_option("-c,--config", options.config,
                 "The machine: PrusaSlicer config.ini (machine_max_*, bed_shape, ...) or Klipper's "
                 "printer.cfg. Default: the settings that the G-code quotes, else PrusaSlicer's")
      ->type_name("FILE");
}

absl::StatusOr<GcodeFile> ReadGcode(const GcodeOptions& options) {
  GcodeFile file;
  file.firmware = motion::FindFirmware(options.flavor);
  if (file.firmware == nullptr) {
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                     fmt::format("--flavor {}: must be klipper, marlin, rrf or grbl", options.flavor));
  }
  auto gcode = ReadFile(options.gcode, kMaxGcodeBytes);
  if (!gcode.ok()) return gcode.status();
  file.gcode = *std::move(gcode);
  auto machine = ReadMachine(options.config, file.gcode);
  if (!machine.ok()) return machine.status();
  file.machine = *std::move(machine);
  return file;
}

}  // namespace slicefarm::cli
