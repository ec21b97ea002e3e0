#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "services/slicing/algo/mesh_io/threemf/package/archive.h"
#include "services/slicing/algo/mesh_io/threemf/settings/height_profiles.h"
#include "services/slicing/algo/mesh_io/threemf/settings/height_ranges.h"
#include "services/slicing/algo/mesh_io/threemf/settings/object_settings.h"
#include "services/slicing/algo/mesh_io/threemf/settings/project_settings.h"

namespace slicefarm::slicing::threemf {

/// What slicers put beside the model.
struct Metadata {
  SettingsDialect dialect = SettingsDialect::kPrusa;
  ProjectSettings project;
  ModelSettings model;
  std::vector<PlateSettings> beds;  ///< PrusaSlicer's, without members; none if there is but one
  HeightRanges ranges;
  HeightProfiles profiles;
  /// Whether the project was saved for some printer: only then its places mean anything.
  bool has_printer = false;
};

/// Reads PrusaSlicer's files, or those of Bambu Studio and OrcaSlicer if there are any.
/// Errors: those of the readers of each.
absl::StatusOr<Metadata> ReadMetadata(const Archive& archive);

/// What the archive has besides that would make another print and has no effect, in words of people
/// who use slicers. Pictures of the parts and the place of a wipe tower are none of that.
/// Errors: those of the archive.
absl::StatusOr<std::vector<std::string>> FilesWithoutEffect(const Archive& archive);

}  // namespace slicefarm::slicing::threemf
