#pragma once

#include "absl/status/statusor.h"
#include "common/model/scene/scene.h"
#include "services/slicing/algo/mesh_io/threemf/package.h"
#include "services/slicing/algo/mesh_io/threemf/settings/metadata.h"

namespace slicefarm::slicing::threemf {

/// Returns a project of the objects that a package builds and of their slicer settings.
///
/// The order of objects is the order in which the build items first refer to them. An object with
/// only one component, which is another object and not moved, counts as a copy of that object
/// (PrusaSlicer's copies). Positions are used only if the project was saved for a printer.
///
/// Errors: MESH_MALFORMED with the location in the file for inconsistent contents; MESH_EMPTY if a
/// part has no triangle, or if there is nothing to build; MESH_TOO_LARGE above limits::kMaxParts
/// parts, kMaxTriangles triangles of all parts, or kMaxProjectBytes of settings.
absl::StatusOr<Project> MakeProject(const Package& package, Metadata metadata);

}  // namespace slicefarm::slicing::threemf
