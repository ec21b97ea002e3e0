#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/missing_feature.h"
#include "common/model/scene/scene.h"

namespace slicefarm::config {

/// Job that is made from one plate of a project file.
struct ProjectJob {
  /// settings of the project, followed by settings of the plate, which override them
  std::vector<Setting> settings;
  /// Objects on the plate, with their printable copies only. Objects without a printable copy are
  /// left out.
  std::vector<SceneObject> objects;
  /// Contents of the project that no stage uses, as lines for the report.
  std::vector<std::string> without_effect;
  /// Lines of `without_effect` that need a warning: settings that change the print, and contents
  /// other than settings (painted areas, pauses at heights, left-out parts).
  std::vector<std::string> warnings;
  /// Missing features that spoil the print of this plate: painted filaments. They are not among the
  /// warnings.
  std::vector<MissingFeature> missing;

  friend bool operator==(const ProjectJob&, const ProjectJob&) = default;
};

/// Returns the project with all settings under PrusaSlicer's names and values, as settings of a
/// profile. Unknown settings are therefore reported later and not refused. Settings without an
/// equivalent in PrusaSlicer are added to Project::without_effect.
Project InPrusaNames(Project project);

/// Returns the number of the filament that all objects of a plate print with, from 0. If there are
/// several, it returns the first one: such a plate is refused later. Errors: as JobOfProject for
/// `plate`.
absl::StatusOr<size_t> FilamentOf(const Project& project, int plate);

/// Returns the job of one plate of a project, in the form of InPrusaNames.
///
/// `plate`: number of the plate from 1, or 0 for the only plate that has objects. Errors:
/// REQUEST_MALFORMED (metadata `field`: `plate`, and `plates`: number of plates) for a plate that
/// does not exist, and for 0 if several plates have objects. NOTHING_TO_PRINT for a plate without
/// printable copies.
absl::StatusOr<ProjectJob> JobOfProject(const Project& project, int plate);

}  // namespace slicefarm::config
