#pragma once

#include <set>
#include <string>
#include <vector>

#include "common/config/presets/choose_presets.h"
#include "common/config/presets/preset_set.h"
#include "common/model/scene/scene.h"

namespace slicefarm::config::presets {

/// Settings of a project that its designer changed, by the kind of the preset that has them. Lists
/// have one value, for the filament that prints.
struct DesignerChanges {
  std::vector<Setting> process;
  std::vector<Setting> filament;
  std::vector<std::string> of_printer;  ///< keys of changed settings of the printer
  FormerPresets former;                 ///< presets that the project was made with
  double nozzle_mm = 0;                 ///< 0: unknown
  /// True if the changes are not known, because the project has no list of them and its process is
  /// not among the presets. `process` then has all settings that describe the part.
  bool unknown = false;
};

/// Returns the changes of a project.
/// - OrcaSlicer and Bambu Studio list them (`different_settings_to_system`).
/// - PrusaSlicer and SuperSlicer do not: a change is a difference from the process and the filament
///   that the project names, or from their parents, if they are in `set`.
/// - Otherwise, and for a process that a user made without a parent, see DesignerChanges::unknown.
///
/// `filament`: number of the printing filament, from 0. Cost: O(n log n) for n settings.
DesignerChanges ChangesOf(const Project& project, size_t filament, const PresetSet& set);

}  // namespace slicefarm::config::presets
