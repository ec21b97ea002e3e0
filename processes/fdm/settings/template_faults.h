#pragma once

#include "absl/status/status.h"
#include "common/config/draft.h"
#include "common/config/resolve.h"

namespace slicefarm::config::fdm {

/// Takes the G-code template that `fault` names out of the settings and tells `gcode_templates` as
/// missing. Returns false for a fault of no template, for one that somebody has written by hand, and
/// for start_gcode and end_gcode: a machine that is not homed, or whose heaters stay on, is a
/// danger.
bool LeaveOutTemplate(const absl::Status& fault, const Draft& draft, ResolvedSettings& result);

}  // namespace slicefarm::config::fdm
