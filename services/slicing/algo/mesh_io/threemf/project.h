#pragma once

#include "absl/status/statusor.h"
#include "common/model/scene/scene.h"
#include "services/slicing/algo/mesh_io/threemf/package.h"
#include "services/slicing/algo/mesh_io/threemf/settings/metadata.h"

namespace slicefarm::slicing::threemf {

/// The objects that a package builds, with what its slicer says of them.
///
/// Objects stand in the order in which the build first names them; an object whose only component
/// is another one, unmoved, is that other one (PrusaSlicer's copies). Places count only in a
/// project that was saved for a printer. Errors: MESH_MALFORMED with a place for what does not fit
/// together; MESH_EMPTY for parts without a triangle, and if nothing is to be built;
/// MESH_TOO_LARGE.
absl::StatusOr<Project> MakeProject(const Package& package, Metadata metadata);

}  // namespace slicefarm::slicing::threemf
