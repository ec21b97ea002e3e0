#pragma once

#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/resolve.h"

namespace slicefarm::config {

/// The settings of a PrusaSlicer config.ini, or those quoted at the end of a G-code file, in their
/// order, as kProfile. Lines are `key = value`; empty lines and those that start with `#` or `;`
/// say nothing; values keep their escapes. Takes a byte order mark and either line ending. What
/// SuperSlicer wrote comes as PrusaSlicer would have it (super_settings.h). Errors:
/// SETTING_MALFORMED naming the line; also for a config bundle (a file with sections), for a file
/// without any setting and for what is not text. REQUEST_TOO_LARGE past the limits.
/// Cost: O(n log n).
absl::StatusOr<std::vector<Setting>> ReadIni(std::string_view text);

}  // namespace slicefarm::config
