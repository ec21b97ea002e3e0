#pragma once

#include "absl/status/status.h"
#include "common/config/draft.h"

namespace slicefarm::config::fdm {

/// Joins G-code that follows each other: to the stages it is one setting.
/// - end_filament_gcode comes before end_gcode. start_filament_gcode stays apart from start_gcode,
///   since the machine is heated between the two.
/// - time_lapse_gcode comes before layer_gcode, on machines of Bambu Lab's after it, as OrcaSlicer
///   and Bambu Studio have it.
/// Errors: those of CheckSettingSize.
absl::Status JoinGcode(Draft& draft);

/// Returns an error in a line of joined G-code (metadata `setting` and `line`) with the setting that
/// the line is written in, and its line there. Other errors as they are.
absl::Status NamingOwnGcode(const absl::Status& status, const Draft& draft);

}  // namespace slicefarm::config::fdm
