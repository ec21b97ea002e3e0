#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/config/presets/preset_file.h"
#include "common/config/presets/preset_set.h"

namespace slicefarm::config::presets {

/// Returns the presets in `files`. Formats:
/// - folders of OrcaSlicer and Bambu Studio: VENDOR.json with the folder VENDOR, presets of users;
/// - exports of these programs: single JSON files and archives;
/// - bundles and presets of PrusaSlicer and SuperSlicer, flat config.ini files.
///
/// Of the files in a vendor's folder, only files that the vendor's list names are used, as in
/// OrcaSlicer. Files are read in the order of their paths, vendors before users, so that the result
/// does not depend on the order of `files`.
///
/// `max_bytes`: limit of all files, expanded.
///
/// A file that cannot be read is a line of PresetSet::problems, and its presets are missing.
/// Errors: SETTING_MALFORMED if no file has a preset, with the first problem; REQUEST_TOO_LARGE
/// beyond the limits of preset_file.h. Cost: O(n log n) of the bytes.
absl::StatusOr<PresetSet> ReadPresets(std::vector<PresetFile> files,
                                      int64_t max_bytes = kMaxPresetBytes);

}  // namespace slicefarm::config::presets
