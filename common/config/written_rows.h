#pragma once

#include <span>

#include "absl/status/status.h"
#include "common/model/process.h"
#include "common/model/scene/scene.h"

namespace slicefarm::config {

/// Whether the regions of all objects have at most limits::kMaxRegionSettings sets of settings that
/// are written differently: before any is resolved, which takes about a millisecond each. What
/// modifiers make of them is not counted. Errors: REQUEST_TOO_LARGE. Cost: O(n) for n bytes of
/// settings, and one look-up for each part in each range of heights.
absl::Status CheckWrittenRows(std::span<const SceneObject> objects, Process process);

}  // namespace slicefarm::config
