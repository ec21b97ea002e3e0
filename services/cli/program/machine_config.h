#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "services/motion/algo/program/program_check.h"

namespace slicefarm::cli {

/// Machine for which a G-code file is made.
struct MachineConfig {
  motion::CheckSetup setup;
  std::string source;  ///< origin of the data: a file's name, "gcode" or "defaults"
};

/// Reads the machine from a PrusaSlicer config.ini (machine_max_*, bed_shape, ...; other keys are
/// ignored), or from a G-code file of PrusaSlicer or OrcaSlicer that contains these settings.
/// Errors: see ReadIni and Resolve.
absl::StatusOr<motion::CheckSetup> SetupOfSettings(std::string_view text);

/// Returns the firmware that the settings in a G-code file name (gcode_flavor); nullptr if they
/// name none.
const motion::Firmware* FirmwareNamedIn(std::string_view gcode);

/// Returns the machine of a G-code file. `config_file`: the file of --config, which is a Klipper
/// printer.cfg if it has a section [printer], and a settings file otherwise. If `config_file` is
/// empty, uses the settings in the G-code. If the G-code has no readable settings, uses
/// PrusaSlicer's defaults; the shape of the bed and the largest print height are then not known.
absl::StatusOr<MachineConfig> ReadMachine(const std::string& config_file, std::string_view gcode);

}  // namespace slicefarm::cli
