#pragma once

#include <string_view>

#include "absl/status/statusor.h"
#include "services/motion/algo/program/program_check.h"

namespace slicefarm::cli {

/// Whether a text has a section [printer].
bool IsKlipperConfig(std::string_view text);

/// What Klipper's printer.cfg says in [printer], [extruder], [firmware_retraction] and [stepper_x]
/// to [stepper_z]; the rest is as Klipper takes it by default. Errors: SETTING_MALFORMED for a number
/// that is none, or without max_velocity and max_accel.
absl::StatusOr<motion::CheckSetup> ReadKlipperConfig(std::string_view text);

}  // namespace slicefarm::cli
