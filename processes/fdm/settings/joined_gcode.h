#pragma once

#include "absl/status/status.h"
#include "common/config/setting_values.h"

namespace slicefarm::config::fdm {

/// Joins G-code settings that the printer executes one after the other, so that stages see one
/// setting.
/// - end_filament_gcode comes before end_gcode. start_filament_gcode is separate from start_gcode,
///   since the machine is heated between the two.
/// - change_extrusion_role_gcode comes before the setting of the filament with this name, and this
///   before the setting of the process.
/// - time_lapse_gcode comes before layer_gcode. On machines of Bambu Lab it comes after
///   layer_gcode, as in OrcaSlicer and Bambu Studio.
/// - wrapping_detection_gcode comes before both, and only after each of the lowest
///   wrapping_detection_layers layers.
///
/// Errors: REQUEST_TOO_LARGE if a joined text is too long (CheckSettingSize).
absl::Status JoinGcode(SettingValues& draft);

/// Converts an error about a line of joined G-code (metadata `setting` and `line`): the result
/// names the original setting of this line, and the line's number in that setting. Returns other
/// errors unchanged.
absl::Status NamingOwnGcode(const absl::Status& status, const SettingValues& draft);

}  // namespace slicefarm::config::fdm
