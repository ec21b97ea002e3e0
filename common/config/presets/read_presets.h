#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/config/presets/preset_file.h"
#include "common/config/presets/preset_set.h"

namespace slicefarm::config::presets {

/// Returns the presets of files: folders of OrcaSlicer and Bambu Studio (VENDOR.json with the
/// folder VENDOR, and presets of users), their exports (single JSON files and archives), bundles
/// and presets of PrusaSlicer and SuperSlicer, and flat config.ini files. Other files are left out.
///
/// As in OrcaSlicer, only those files of a vendor's folder count that the vendor's list names.
/// `files` are read in the order of their paths, vendors before users, so that the result does not
/// depend on the order of a folder.
///
/// A file that cannot be read is a line of PresetSet::problems, and its presets are missing.
/// Errors: SETTING_MALFORMED if no file has a preset, with the first problem; REQUEST_TOO_LARGE
/// beyond the limits of preset_file.h. Cost: O(n log n) of the bytes.
absl::StatusOr<PresetSet> ReadPresets(std::vector<PresetFile> files);

}  // namespace slicefarm::config::presets
