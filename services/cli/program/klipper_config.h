#pragma once

#include <string_view>

#include "absl/status/statusor.h"
#include "services/motion/algo/program/program_check.h"

namespace slicefarm::cli {

/// Returns true if the text has a section [printer], as Klipper's printer.cfg has.
bool IsKlipperConfig(std::string_view text);

/// Reads the sections [printer], [extruder], [firmware_retraction] and [stepper_x] to [stepper_z]
/// of Klipper's printer.cfg. Missing values get Klipper's defaults. Errors: SETTING_MALFORMED for
/// an invalid number, or without max_velocity and max_accel.
absl::StatusOr<motion::CheckSetup> ReadKlipperConfig(std::string_view text);

}  // namespace slicefarm::cli
