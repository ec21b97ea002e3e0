#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/presets/flat_json.h"
#include "common/config/presets/preset.h"
#include "common/config/presets/preset_file.h"

namespace slicefarm::config::presets {

/// Returns true if the object is a vendor's list of presets (VENDOR.json of OrcaSlicer and Bambu
/// Studio).
bool IsVendorList(const FlatJson& json);

/// Returns the paths of a vendor's presets, relative to the vendor's folder, in the order of the
/// list. Errors: SETTING_MALFORMED.
absl::StatusOr<std::vector<std::string>> PathsOfVendorList(std::string_view text);

/// Content of a JSON file: a preset, a printer model, or neither.
struct OrcaFile {
  enum class Is : uint8_t { kPreset, kModel, kOther };
  Is is = Is::kOther;
  Preset preset;
  PrinterModel model;
};

/// Returns the content of a JSON file. If the file names neither the kind nor the name of a preset,
/// `path` decides: a folder's name is the kind, the file's name is the preset's name. `of_vendor`:
/// true for a vendor's file, which may include further presets as parents. A file without a kind is
/// kOther.
OrcaFile ReadOrcaFile(const std::string& path, FlatJson json, bool of_vendor);

}  // namespace slicefarm::config::presets
