#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "services/motion/algo/program/program_check.h"

namespace slicefarm::cli {

/// Machine that a G-code file is for.
struct MachineConfig {
  motion::CheckSetup setup;
  std::string source;  ///< origin: a file's name, "gcode", "defaults"
};

/// Reads the machine from a PrusaSlicer config.ini (machine_max_*, bed_shape, ...; other keys are
/// ignored). Also accepts a G-code file of PrusaSlicer or OrcaSlicer that quotes such settings.
/// Errors: as ReadIni and Resolve.
absl::StatusOr<motion::CheckSetup> SetupOfSettings(std::string_view text);

/// Returns the machine of --config: Klipper's printer.cfg if it has a section [printer], otherwise
/// settings. Without it (`config_file` empty) the settings quoted in the G-code are used if they
/// can be read. Otherwise PrusaSlicer's defaults are used; bed and height are then not known.
absl::StatusOr<MachineConfig> ReadMachine(const std::string& config_file, std::string_view gcode);

}  // namespace slicefarm::cli
