#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/model/options/setting.h"
#include "common/model/scene/scene.h"

namespace slicefarm::config::fdm {

/// The extruder, from 1, with which all that is printed of a plate is printed: by `extruder`,
/// `perimeter_extruder`, `infill_extruder` and `solid_infill_extruder` of the job, of objects with
/// a printable copy, of their parts, modifiers and ranges of heights, as PrusaSlicer has them.
/// Takes those settings out of `job` and `objects`, and puts `extruder` into `job` unless it is the
/// first one. Errors: SETTING_OUT_OF_RANGE with metadata `setting` and `objects` if several
/// extruders are asked for, or one that is no number.
absl::Status TakeTool(std::vector<Setting>& job, std::vector<SceneObject>& objects);

}  // namespace slicefarm::config::fdm
