#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "services/motion/algo/program/program_check.h"

namespace slicefarm::cli {

/// The machine that a G-code file is for.
struct MachineConfig {
  motion::CheckSetup setup;
  std::string source;  ///< where it comes from: a file's name, "gcode", "defaults"
};

/// Of a PrusaSlicer config.ini (machine_max_*, bed_shape, ...; other keys say nothing here) or a
/// G-code file that quotes one, PrusaSlicer's or OrcaSlicer's. Errors: those of ReadIni and Resolve.
absl::StatusOr<motion::CheckSetup> SetupOfSettings(std::string_view text);

/// By --config: Klipper's printer.cfg if it has its [printer], else settings. Without one
/// (`config_file` empty): by the settings that the G-code quotes, if they can be read, else
/// PrusaSlicer's defaults; bed and height are then not known.
absl::StatusOr<MachineConfig> ReadMachine(const std::string& config_file, std::string_view gcode);

}  // namespace slicefarm::cli
