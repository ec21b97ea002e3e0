#pragma once

#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/resolve.h"

namespace slicefarm::config {

/// Reads the settings of a PrusaSlicer config.ini, or the settings quoted at the end of a G-code
/// file, in the file's order. The source of the settings is kProfile. Lines are `key = value`;
/// empty lines and lines that start with `#` or `;` are ignored. Values keep their escapes. A byte
/// order mark and both kinds of line ending are accepted. Settings from SuperSlicer are converted
/// to PrusaSlicer's (super_settings.h).
///
/// Errors: SETTING_MALFORMED with the line, for a malformed line, for a config bundle (a file with
/// sections), for a file without settings and for a file that is not text. REQUEST_TOO_LARGE beyond
/// the limits. Cost: O(n log n) for n lines.
absl::StatusOr<std::vector<Setting>> ReadIni(std::string_view text);

}  // namespace slicefarm::config
