#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/presets/choose_presets.h"
#include "common/config/presets/preset_set.h"
#include "common/config/presets/setting_sources.h"
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
  std::vector<std::string> of_print;  ///< settings without effect that change the print
  std::vector<std::string> others;    ///< further settings without effect
  std::vector<SettingSource>
      sources;  ///< sources of `settings`: presets and the program's defaults
};

/// Returns the values of CombinePresets with their sources as text.
std::vector<LabelledSetting> Labelled(const std::vector<SourcedValue>& values);

/// Returns the settings of CombinePresets in PrusaSlicer's names and values. Errors: as
/// CombinePresets.
absl::StatusOr<JobPresets> SettingsOfPresets(const PresetSet& set, const ChosenPresets& chosen);

}  // namespace slicefarm::config::presets
