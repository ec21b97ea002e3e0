#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "absl/status/status.h"
#include "common/model/scene/scene.h"
#include "common/model/setting.h"

namespace slicefarm::config {

/// What settings take once they are resolved, by the length of their texts: each place that has
/// settings of its own has all of the job's as well. Of the job's long texts, which all places
/// share, each is counted for a part of its length: they are only passed over.
class ResolvedBytes {
 public:
  /// One more set of settings. Errors: REQUEST_TOO_LARGE if all of them take more than
  /// limits::kMaxResolvedBytes.
  absl::Status Add(int64_t bytes);

 private:
  int64_t bytes_ = 0;
};

/// Keys and values.
int64_t BytesOf(std::span<const Setting> settings);
/// What the job's settings add to a set.
int64_t BytesOfJob(std::span<const Setting> settings);

/// Whether the settings of all objects, parts and ranges of heights can be resolved, before any is:
/// counts each different set once, but for what modifiers make of the rows that they lie in.
/// Errors: those of ResolvedBytes::Add. Cost: O(n) for n bytes of settings, and one look-up for
/// each part in each range.
absl::Status CheckResolvedBytes(std::span<const Setting> job, std::span<const SceneObject> objects);

}  // namespace slicefarm::config
