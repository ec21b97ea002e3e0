#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "services/cli/program/machine_config.h"

namespace CLI {
class App;
}

namespace slicefarm::cli {

/// Options that `time` and `check` have in common, as written on the command line.
struct GcodeOptions {
  std::string gcode;
  std::string flavor;
  std::string config;
  int plate = 0;  ///< number of the plate in an archive; 0: the only one
};

/// G-code file, with the firmware flavour and the machine for which it is made.
struct GcodeFile {
  std::string gcode;
  const motion::Firmware* firmware = nullptr;
  MachineConfig machine;
};

/// Adds the option --plate, which selects a plate of an archive.
void AddPlateOption(CLI::App& app, int& plate);

/// Adds these options to a command.
void AddGcodeOptions(CLI::App& app, GcodeOptions& options);

/// Returns the error REQUEST_MALFORMED for an unknown firmware flavour, with the names of the known
/// flavours.
absl::Status UnknownFlavor(std::string_view flavor);

/// Reads the file and determines its machine. Errors: see ReadFile and ReadMachine;
/// REQUEST_MALFORMED for an unknown flavour.
absl::StatusOr<GcodeFile> ReadGcode(const GcodeOptions& options);

}  // namespace slicefarm::cli
