#pragma once

#include "absl/status/statusor.h"
#include "common/model/scene/scene.h"
#include "services/slicing/algo/mesh_io/threemf/package.h"
#include "services/slicing/algo/mesh_io/threemf/settings/metadata.h"

namespace slicefarm::slicing::threemf {

/// Makes a project of the objects that a package builds and of their slicer settings.
///
/// Objects are in the order in which the list of build items first refers to them. An object with
/// only one component, which is another object and not moved, counts as a copy of that object
/// (PrusaSlicer's copies). Positions are used only if the project was saved for a printer.
///
/// Errors: MESH_MALFORMED with the location in the file for inconsistent contents; MESH_EMPTY for
/// parts without a triangle and if nothing is to be built; MESH_TOO_LARGE.
absl::StatusOr<Project> MakeProject(const Package& package, Metadata metadata);

}  // namespace slicefarm::slicing::threemf
