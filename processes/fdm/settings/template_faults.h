#pragma once

#include "absl/status/status.h"
#include "common/config/resolve.h"
#include "common/config/setting_values.h"

namespace slicefarm::config::fdm {

/// Removes the G-code template that `fault` names from the settings and reports `gcode_templates`
/// as missing. Returns false without a change if the fault concerns no template, or a template that
/// the request set itself. Also returns false for start_gcode and end_gcode: a machine that is not
/// homed, or with heaters that stay on, is dangerous.
bool LeaveOutTemplate(const absl::Status& fault, const SettingValues& draft,
                      ResolvedSettings& result);

}  // namespace slicefarm::config::fdm
