#pragma once

#include "absl/status/statusor.h"
#include "common/model/scene/scene.h"
#include "services/slicing/algo/mesh_io/raw_mesh.h"

namespace slicefarm::slicing {

/// The triangles of `mesh` that `ref` names, with the corners that they have, in the mesh's order.
/// Errors: REQUEST_MALFORMED if the mesh has not so many triangles; MESH_EMPTY for no triangle.
/// Cost: O(corners + triangles).
absl::StatusOr<RawMesh> MeshPart(const RawMesh& mesh, const MeshRef& ref);

}  // namespace slicefarm::slicing
