#pragma once

#include "absl/status/status.h"
#include "common/config/draft.h"

namespace slicefarm::config::fdm {

/// The filament's own G-code is the first after the layers: to the stages it is the beginning of
/// end_gcode. What it has before the layers stays apart from start_gcode, since the machine is
/// heated between the two.
/// Errors: those of CheckSettingSize.
absl::Status JoinFilamentGcode(Draft& draft);

/// An error in a line of end_gcode (metadata `setting` and `line`), with the setting
/// that the line is written in, and its line there. Other errors as they are.
absl::Status NamingOwnGcode(const absl::Status& status, const Draft& draft);

}  // namespace slicefarm::config::fdm
