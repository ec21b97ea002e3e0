#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/config/missing_feature.h"
#include "common/model/scene/scene.h"
#include "common/model/setting.h"

namespace slicefarm::config::fdm {

/// Finds the extruder, counted from 1, with which the whole plate is printed. It evaluates
/// `extruder`, `perimeter_extruder`, `infill_extruder` and `solid_infill_extruder` as PrusaSlicer
/// does. These settings may be in the job, in objects with a printable copy, and in their parts,
/// modifiers and ranges of heights. If there are several extruders, the first one is used, and
/// `missing` gets `several_tools` (metadata `setting`, `objects`).
///
/// Removes these settings from `job` and `objects`. Adds `extruder` to `job` unless it is the first
/// one. Errors: SETTING_OUT_OF_RANGE with metadata `setting` for a value that is not a number.
absl::Status UnifyTool(std::vector<Setting>& job, std::vector<SceneObject>& objects,
                       std::vector<MissingFeature>& missing);

}  // namespace slicefarm::config::fdm
