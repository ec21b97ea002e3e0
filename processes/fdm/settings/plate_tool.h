#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/config/missing_feature.h"
#include "common/model/scene/scene.h"
#include "common/model/setting.h"

namespace slicefarm::config::fdm {

/// The extruder, from 1, with which all that is printed of a plate is printed: by `extruder`,
/// `perimeter_extruder`, `infill_extruder` and `solid_infill_extruder` of the job, of objects with
/// a printable copy, of their parts, modifiers and ranges of heights, as PrusaSlicer has them. Of
/// several it is the first, and `missing` gets `several_tools` (metadata `setting`, `objects`).
/// Takes those settings out of `job` and `objects`, and puts `extruder` into `job` unless it is the
/// first one. Errors: SETTING_OUT_OF_RANGE with metadata `setting` for one that is no number.
absl::Status TakeTool(std::vector<Setting>& job, std::vector<SceneObject>& objects,
                      std::vector<MissingFeature>& missing);

}  // namespace slicefarm::config::fdm
