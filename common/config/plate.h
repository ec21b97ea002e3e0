#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/config/resolve.h"
#include "common/model/scene/scene.h"
#include "common/stage/slice_input.h"
#include "common/stage/stages.h"

namespace slicefarm::config {

/// Input of a job: a plate of objects with all settings resolved.
struct ResolvedPlate {
  JobSettings settings;
  std::vector<ObjectInput> objects;
  int64_t region_rows = 0;  ///< number of different sets of region settings
  /// ResolvedSettings::effective_text of the job's settings. If objects have settings of their own,
  /// a line `object_settings = ` with these settings as JSON follows.
  std::string effective_text;
  /// Notes as in ResolvedSettings. Notes on an object begin with the object's name.
  std::vector<SettingNote> no_effect;
  int64_t beside_print = 0;
  std::vector<std::string> warnings;
  /// Missing features for which the job is refused unless it allows them (CheckMissing). `warnings`
  /// contains their texts as well.
  std::vector<MissingFeature> missing;
};

/// Resolves the settings of job, objects, parts, modifiers and height ranges into tables, and
/// converts the objects to the input of slicing. Settings of a narrower level override wider
/// levels, in the order job, object, part, range. Modifiers then change the volumes inside them,
/// one after the other (the order of PrusaSlicer). Copies with different rotation or scale become
/// separate objects; equal objects become copies of one object.
///
/// Errors:
/// - any error of Resolve, with the object's name in front;
/// - SETTING_MISPLACED for a kRequest key that is not allowed at its level (metadata `object`,
///   `setting`);
/// - REQUEST_TOO_LARGE for more than limits::kMaxRegionSettings different sets of settings, or for
///   settings that are too large (CheckResolvedBytes, before any settings are resolved);
/// - REQUEST_MALFORMED for invalid height ranges;
/// - NOTHING_TO_PRINT if no copy is printable;
/// - the error of `cancel`, which is checked before each set of settings is resolved.
absl::StatusOr<ResolvedPlate> ResolvePlate(std::span<const Setting> job,
                                           std::span<const SceneObject> objects, Process process,
                                           const CancelToken& cancel = {});

}  // namespace slicefarm::config
