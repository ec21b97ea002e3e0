#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "services/cli/program/machine_config.h"

namespace CLI {
class App;
}

namespace slicefarm::cli {

/// Options of `time` and `check`, as written on the command line.
struct GcodeOptions {
  std::string gcode;
  std::string flavor;
  std::string config;
};

/// G-code file, with the firmware and the machine that read it.
struct GcodeFile {
  std::string gcode;
  const motion::Firmware* firmware = nullptr;
  MachineConfig machine;
};

/// Adds these options to a command.
void AddGcodeOptions(CLI::App& app, GcodeOptions& options);

/// Returns REQUEST_MALFORMED with the names of the known flavours.
absl::Status UnknownFlavor(std::string_view flavor);

/// Reads the file and its machine. Errors: as ReadFile and ReadMachine; REQUEST_MALFORMED for an
/// unknown flavour.
absl::StatusOr<GcodeFile> ReadGcode(const GcodeOptions& options);

}  // namespace slicefarm::cli
