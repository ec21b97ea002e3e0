#pragma once

#include "absl/status/statusor.h"
#include "common/model/scene/scene.h"
#include "services/slicing/algo/mesh_io/raw_mesh.h"

namespace slicefarm::slicing {

/// Returns the triangles of `mesh` to which `ref` refers, in the order of the mesh, with the
/// corners that they use. Errors: REQUEST_MALFORMED if the mesh has fewer triangles than `ref`
/// needs; MESH_EMPTY if there is no triangle. Cost: O(corners + triangles).
absl::StatusOr<RawMesh> MeshPart(const RawMesh& mesh, const MeshRef& ref);

}  // namespace slicefarm::slicing
