#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/config/presets/preset_file.h"
#include "common/config/presets/preset_set.h"

namespace slicefarm::config::presets {

/// Returns the presets of files. Files without presets are left out. Formats:
/// - folders of OrcaSlicer and Bambu Studio: VENDOR.json with the folder VENDOR, presets of users;
/// - exports of these programs: single JSON files and archives;
/// - bundles and presets of PrusaSlicer and SuperSlicer, flat config.ini files.
///
/// As in OrcaSlicer, a file of a vendor's folder counts only if the vendor's list names it.
/// `files` are read in the order of their paths, vendors before users, so that the result does not
/// depend on the order of a folder.
///
/// A file that cannot be read is a line of PresetSet::problems, and its presets are missing.
/// Errors: SETTING_MALFORMED if no file has a preset, with the first problem; REQUEST_TOO_LARGE
/// beyond the limits of preset_file.h. Cost: O(n log n) of the bytes.
absl::StatusOr<PresetSet> ReadPresets(std::vector<PresetFile> files);

}  // namespace slicefarm::config::presets
