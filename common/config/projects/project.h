#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/missing_feature.h"
#include "common/model/scene/scene.h"

namespace slicefarm::config {

/// Part of a project file that becomes a job.
struct ProjectJob {
  std::vector<Setting> settings;  ///< settings of the project, then of the plate
  /// Objects with their printable copies; objects without such copies are left out.
  std::vector<SceneObject> objects;
  /// Other contents of the project that no stage uses, as lines for the report.
  std::vector<std::string> without_effect;
  /// Lines of `without_effect` that are not settings (painted areas, pauses at heights, left-out
  /// parts) or that change the print.
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

/// Returns the job of one plate of a project, in the form of InPrusaNames.
///
/// `plate`: number from 1; 0: the only plate that has objects. Errors: REQUEST_MALFORMED (metadata
/// `field`: `plate`, and `plates`: number of plates) for a plate that does not exist, and for 0 if
/// several plates have objects. NOTHING_TO_PRINT for a plate without printable copies.
absl::StatusOr<ProjectJob> JobOfProject(const Project& project, int plate);

}  // namespace slicefarm::config
