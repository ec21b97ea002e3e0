#pragma once

#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "common/config/presets/preset_file.h"
#include "common/config/presets/preset_set.h"

namespace slicefarm::config::presets {

/// Adds the presets of an .ini file of PrusaSlicer or SuperSlicer to `set`. The file is one of
/// - a vendor's bundle, with a section `[vendor]`, or an exported bundle: sections
///   `[print:NAME]`, `[filament:NAME]` and `[printer:NAME]`. `inherits` may name several parents
///   separated by `;`. Presets with names in `*` are bases only;
/// - a preset of a user, in a folder `print`, `filament` or `printer`;
/// - the flat config.ini of a whole job, which becomes one preset of each kind.
///
/// Errors: SETTING_MALFORMED naming the line, also for a section or key that occurs twice;
/// REQUEST_TOO_LARGE beyond the limits. In this case nothing is added. Cost: O(n log n).
absl::Status AddIni(const PresetFile& file, PresetSet& set);

}  // namespace slicefarm::config::presets
