#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "services/slicing/algo/mesh_io/threemf/package/archive.h"
#include "services/slicing/algo/mesh_io/threemf/settings/height_profiles.h"
#include "services/slicing/algo/mesh_io/threemf/settings/height_ranges.h"
#include "services/slicing/algo/mesh_io/threemf/settings/object_settings.h"
#include "services/slicing/algo/mesh_io/threemf/settings/project_settings.h"

namespace slicefarm::slicing::threemf {

/// Data that slicers store beside the model.
struct Metadata {
  SettingsDialect dialect = SettingsDialect::kPrusa;
  ProjectSettings project;
  ModelSettings model;
  /// Beds of PrusaSlicer, without members; empty if there is only one bed.
  std::vector<PlateSettings> beds;
  HeightRanges ranges;
  HeightProfiles profiles;
  /// True if the project was saved for a printer; only then its positions are meaningful.
  bool has_printer = false;
};

/// Reads the files of Bambu Studio and OrcaSlicer if there are any, otherwise the files of
/// PrusaSlicer. Errors: any error of the readers in this folder.
absl::StatusOr<Metadata> ReadMetadata(const Archive& archive);

/// Returns a description of each file in the archive that would change the print in its slicer but
/// has no effect in slicefarm. The descriptions use terms familiar to users of slicers. Pictures of
/// the parts and the position of a wipe tower are not listed. Errors: any error of Archive.
absl::StatusOr<std::vector<std::string>> FilesWithoutEffect(const Archive& archive);

}  // namespace slicefarm::slicing::threemf
