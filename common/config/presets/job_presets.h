#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/presets/choose_presets.h"
#include "common/config/presets/preset_set.h"
#include "common/model/setting.h"

namespace slicefarm::config::presets {

/// Setting of a job in the names and values of the presets' program, with its source.
struct SourcedValue {
  std::string key;
  std::string value;
  const Preset* from = nullptr;  ///< nullptr: the program's default, or the name of a preset
};

/// Returns all settings of a job, by key, as the presets' program combines them: its defaults, the
/// process, the printer, and the filament. Settings in a preset of the wrong kind do not count.
/// OrcaSlicer's defaults are included, because they differ from PrusaSlicer's. Lists of compatible
/// presets are left out. Errors: as PresetSet::Lineage.
absl::StatusOr<std::vector<SourcedValue>> CombinePresets(const PresetSet& set,
                                                         const ChosenPresets& chosen);

/// Settings of a job in PrusaSlicer's names.
struct JobPresets {
  std::vector<Setting> settings;
  std::vector<std::string> of_print;  ///< settings without effect that change the print
  std::vector<std::string> others;    ///< further settings without effect
};

/// Returns the settings of CombinePresets in PrusaSlicer's names and values. Errors: as
/// CombinePresets.
absl::StatusOr<JobPresets> SettingsOfPresets(const PresetSet& set, const ChosenPresets& chosen);

}  // namespace slicefarm::config::presets
