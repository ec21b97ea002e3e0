#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/presets/choose_presets.h"
#include "common/config/presets/preset_set.h"
#include "common/model/setting.h"

namespace slicefarm::config::presets {

/// Setting of a job, with its name and value in the presets' program, and with its source.
struct SourcedValue {
  std::string key;
  std::string value;
  const Preset* from = nullptr;  ///< preset that has the value; nullptr: the program's default
};

/// Returns all settings of a job, sorted by key, as the presets' program combines them. The printer
/// overrides the process, and the filament overrides both. A setting is left out if presets of its
/// kind may not have it (MayHaveKey). Lists of compatible presets are left out, too. For
/// OrcaSlicer, its defaults are included, because they differ from PrusaSlicer's. Errors: any error
/// of PresetSet::Lineage.
absl::StatusOr<std::vector<SourcedValue>> CombinePresets(const PresetSet& set,
                                                         const ChosenPresets& chosen);

/// Settings of a job in PrusaSlicer's names.
struct JobPresets {
  std::vector<Setting> settings;
  std::vector<std::string> of_print;  ///< OrcaUnused::of_print; empty for presets of other programs
  std::vector<std::string> others;    ///< OrcaUnused::others, only for settings that a preset has
};

/// Returns the settings of CombinePresets with PrusaSlicer's names and values. Errors: any error of
/// CombinePresets.
absl::StatusOr<JobPresets> SettingsOfPresets(const PresetSet& set, const ChosenPresets& chosen);

}  // namespace slicefarm::config::presets
