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

/// A plate of objects with all settings resolved: what a job works with.
struct ResolvedPlate {
  JobSettings settings;
  std::vector<ObjectInput> objects;
  int64_t region_rows = 0;  ///< different sets of settings of regions
  /// ResolvedSettings::effective_text, and where objects have settings of their own a line
  /// `object_settings = ` with them as JSON.
  std::string effective_text;
  /// See ResolvedSettings; those of an object begin with its name.
  std::vector<std::string> no_effect;
  int64_t beside_print = 0;
  std::vector<std::string> warnings;
  /// What makes the job one to be refused (CheckMissing); `warnings` has each text as well.
  std::vector<MissingFeature> missing;
};

/// Settings of the job, of objects, parts, modifiers and ranges of heights to tables, and objects
/// to what slicing is given. Each narrower place wins over the wider ones: job, object, part,
/// range; modifiers change what they lie in, one after the other (PrusaSlicer's order). Copies that
/// are turned or scaled differently become objects of their own; equal objects become copies of
/// one.
///
/// Errors: those of Resolve, with the object's name in front; SETTING_MISPLACED for a kRequest key
/// that the place cannot have (metadata `object`, `setting`); REQUEST_TOO_LARGE for more than
/// limits::kMaxRegionSettings different sets of settings, or for sets that take too much room
/// (CheckResolvedBytes, before any is resolved); REQUEST_MALFORMED for ranges that are
/// none, NOTHING_TO_PRINT if no copy is printable; `cancel`'s, asked before each set.
absl::StatusOr<ResolvedPlate> ResolvePlate(std::span<const Setting> job,
                                           std::span<const SceneObject> objects, Process process,
                                           const CancelToken& cancel = {});

}  // namespace slicefarm::config
