#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "services/cli/program/machine_config.h"

namespace CLI {
class App;
}

namespace slicefarm::cli {

/// What `time` and `check` are told, as written on the command line.
struct GcodeOptions {
  std::string gcode;
  std::string flavor;
  std::string config;
};

/// A G-code file, and what reads it.
struct GcodeFile {
  std::string gcode;
  const motion::Firmware* firmware = nullptr;
  MachineConfig machine;
};

void AddGcodeOptions(CLI::App& app, GcodeOptions& options);

/// REQUEST_MALFORMED that says which flavours there are.
absl::Status UnknownFlavor(std::string_view flavor);

/// Errors: those of ReadFile and ReadMachine; REQUEST_MALFORMED for an unknown flavour.
absl::StatusOr<GcodeFile> ReadGcode(const GcodeOptions& options);

}  // namespace slicefarm::cli
