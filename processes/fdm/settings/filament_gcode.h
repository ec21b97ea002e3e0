#pragma once

#include "absl/status/status.h"
#include "common/config/draft.h"

namespace slicefarm::config::fdm {

/// The filament's own G-code is the last before the layers and the first after them: to the stages
/// it is the end of start_gcode and the beginning of end_gcode.
/// Errors: those of CheckSettingSize.
absl::Status JoinFilamentGcode(Draft& draft);

/// An error in a line of start_gcode or end_gcode (metadata `setting` and `line`), with the setting
/// that the line is written in, and its line there. Other errors as they are.
absl::Status NamingOwnGcode(const absl::Status& status, const Draft& draft);

}  // namespace slicefarm::config::fdm
