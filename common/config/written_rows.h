#pragma once

#include <span>

#include "absl/status/status.h"
#include "common/model/process.h"
#include "common/model/scene/scene.h"

namespace slicefarm::config {

/// Checks that the regions of all objects have at most limits::kMaxRegionSettings different sets of
/// settings, compared as text. The check is done before any settings are resolved, because it takes
/// about a millisecond to resolve one set. Rows that modifiers make are not counted. Errors:
/// REQUEST_TOO_LARGE. Cost: O(n) for n bytes of settings, and one look-up for each part in each
/// height range.
absl::Status CheckWrittenRows(std::span<const SceneObject> objects, Process process);

}  // namespace slicefarm::config
