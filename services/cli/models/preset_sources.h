#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/presets/choose_presets.h"
#include "common/config/presets/preset_file.h"
#include "common/config/presets/preset_set.h"
#include "services/cli/job/job_options.h"
#include "services/cli/models/given_models.h"

namespace slicefarm::cli {

/// Reads files, and all files with presets of folders and their sub-folders. Symbolic links to
/// folders are not followed. Errors: REQUEST_MALFORMED for a path that cannot be read;
/// REQUEST_TOO_LARGE.
absl::StatusOr<std::vector<config::presets::PresetFile>> ReadPresetFiles(
    const std::vector<std::string>& sources);

/// Returns the presets of ReadPresetFiles. Errors: also as config::presets::ReadPresets.
absl::StatusOr<config::presets::PresetSet> ReadPresetSources(
    const std::vector<std::string>& sources);

/// Returns the names of presets that the options give.
config::presets::PresetNames NamesOf(const PresetOptions& options);

/// Returns the names of chosen presets.
config::presets::PresetNames FullNames(const config::presets::ChosenPresets& chosen);

/// Adds the settings of the chosen presets to the settings of a plate, including settings without
/// effect. Errors: see config::presets::ChoosePresets.
absl::Status TakePresets(const config::presets::PresetSet& set, const PresetOptions& options,
                         GivenPlate& plate);

/// Adds settings of presets without effect to the plate. Settings in `of_print`, which change the
/// print, are also warnings.
void AddUnused(const std::vector<std::string>& of_print, const std::vector<std::string>& others,
               GivenPlate& plate);

}  // namespace slicefarm::cli
