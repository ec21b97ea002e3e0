#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "absl/status/status.h"
#include "common/model/scene/scene.h"
#include "common/model/setting.h"

namespace slicefarm::config {

/// Size of all resolved settings, estimated from the length of their texts. Each object, part or
/// range with settings of its own gets a copy of all settings of the job. Only long texts of the
/// job are stored once for all copies; a fraction of their length counts per copy, because each
/// copy scans the text again.
class ResolvedBytes {
 public:
  /// Adds one more set of settings. Errors: REQUEST_TOO_LARGE if all sets together exceed
  /// limits::kMaxResolvedBytes.
  absl::Status Add(int64_t bytes);

 private:
  int64_t bytes_ = 0;
};

/// Returns the length of all keys and values.
int64_t BytesOf(std::span<const Setting> settings);
/// Returns the size that the job's settings add to each set of settings.
int64_t BytesOfJob(std::span<const Setting> settings);

/// Checks that the settings of all objects, parts and height ranges are small enough, before any
/// settings are resolved. Each different set of settings counts once. Rows that modifiers make are
/// not counted. Errors: REQUEST_TOO_LARGE. Cost: O(n) for n bytes of settings, and one look-up for
/// each part in each range.
absl::Status CheckResolvedBytes(std::span<const Setting> job, std::span<const SceneObject> objects);

}  // namespace slicefarm::config
