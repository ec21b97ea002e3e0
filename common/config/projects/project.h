#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/missing_feature.h"
#include "common/model/scene/scene.h"

namespace slicefarm::config {

/// What a job takes from a project file.
struct ProjectJob {
  std::vector<Setting> settings;     ///< of the project, then of the plate
  std::vector<SceneObject> objects;  ///< with their printable copies; those without are left out
  /// What else the project has that no stage uses, as lines for the report.
  std::vector<std::string> without_effect;
  /// Those of them that are no settings (what was painted, pauses at heights, parts left out) or
  /// make another print.
  std::vector<std::string> warnings;
  /// What spoils the print of this plate: painted filaments. Not among the warnings.
  std::vector<MissingFeature> missing;

  friend bool operator==(const ProjectJob&, const ProjectJob&) = default;
};

/// The project with all settings under PrusaSlicer's names and with its values, as those of a
/// profile: what nobody knows is told later, and not refused. What PrusaSlicer has nothing for
/// joins Project::without_effect.
Project InPrusaNames(Project project);

/// One plate of a project, as InPrusaNames has it.
///
/// `plate`: from 1; 0: the only one that has objects.
/// Errors: REQUEST_MALFORMED (metadata `field`: `plate`, and `plates`: how many there are) for a
/// plate that there is not, and for 0 if several have objects; NOTHING_TO_PRINT for a plate without
/// printable copies.
absl::StatusOr<ProjectJob> JobOfProject(const Project& project, int plate);

}  // namespace slicefarm::config
