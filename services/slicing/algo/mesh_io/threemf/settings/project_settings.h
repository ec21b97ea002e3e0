#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/setting.h"

namespace slicefarm::slicing::threemf {

/// Settings of a whole project as config.ini texts, in the order of the file; settings from JSON
/// are sorted by key. Lists of Bambu Studio and OrcaSlicer stay JSON: `["220","230"]`.
struct ProjectSettings {
  std::vector<Setting> settings;
  bool has_scripts = false;  ///< true if post_process was not empty; its scripts are dropped
};

/// Reads Metadata/Slic3r_PE.config: lines like `; layer_height = 0.2`. `part`: name of this file in
/// the archive, for error messages. Errors: MESH_MALFORMED if the text is not UTF-8; any error of
/// AddSetting, with the line.
absl::StatusOr<ProjectSettings> ReadPrusaSettings(std::string_view text, const std::string& part);

/// Reads Metadata/project_settings.config: one JSON object of texts and lists of texts. `part`:
/// name of this file in the archive, for error messages. Errors: MESH_MALFORMED for any other JSON;
/// any error of AddSetting.
absl::StatusOr<ProjectSettings> ReadOrcaSettings(std::string_view text, const std::string& part);

}  // namespace slicefarm::slicing::threemf
