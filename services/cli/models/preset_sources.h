#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/presets/preset_set.h"
#include "services/cli/job/job_options.h"
#include "services/cli/models/given_models.h"

namespace slicefarm::cli {

/// Reads the presets of files and of folders with their sub-folders. Symbolic links to folders are
/// not followed. Errors: REQUEST_MALFORMED for a path that cannot be read; as
/// config::presets::ReadPresets.
absl::StatusOr<config::presets::PresetSet> ReadPresetSources(
    const std::vector<std::string>& sources);

/// Adds the settings of the chosen presets to the settings of all plates, including settings
/// without effect. Errors: see ReadPresetSources and config::presets::ChoosePresets.
absl::Status TakePresets(const PresetOptions& options, GivenModels& models);

}  // namespace slicefarm::cli
