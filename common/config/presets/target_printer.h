#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/presets/choose_presets.h"
#include "common/config/presets/job_presets.h"
#include "common/config/presets/preset_set.h"
#include "common/model/scene/scene.h"

namespace slicefarm::config::presets {

/// Project that was converted for another printer.
struct TargetedProject {
  Project project;
  ChosenPresets presets;
  /// Settings that the designer changed and that are kept, as the project has them.
  std::vector<Setting> kept;
  /// Settings of the presets without effect. Empty if they are among the project's settings.
  std::vector<std::string> of_print, others;
  /// Sources of the settings under PrusaSlicer's names; the designer's changes are of "project".
  std::vector<SettingSource> sources;
  std::vector<std::string> notes;  ///< changes that are not kept, and other decisions, as lines
};

/// Converts a project for the printer of `names`, as designed: machine, bed, limits, code and
/// filament are the presets', and the designer's changes (designer_changes.h) override the process.
/// Settings of plates, objects, parts and height ranges stay. Settings that do not fit the printer
/// (portable_settings.h) are left out, with a note.
///
/// Without names, the process and the filament correspond to the project's (ChoosePresets).
/// Objects keep their places if both beds are equal. On a larger rectangular bed the plate is moved
/// to the middle. On any other bed the objects are to be arranged anew, with a note.
///
/// `plate`: see JobOfProject. Errors: as ChoosePresets and JobOfProject.
absl::StatusOr<TargetedProject> ForPrinter(Project project, int plate, const PresetSet& set,
                                           const PresetNames& names);

}  // namespace slicefarm::config::presets
