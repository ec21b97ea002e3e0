#pragma once

#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/scene/placed_scene.h"
#include "common/wire/mesh_pieces.h"
#include "slicefarm/v1/slicing.pb.h"

namespace slicefarm {

/// Converts a scene without its meshes. The caller sends the meshes afterwards in pieces, in the
/// order of the parts (mesh_pieces.h).
absl::Status ToProto(const PlacedScene& scene, v1::PlacedScene* proto);
/// Returns the scene without its meshes. Errors: REQUEST_MALFORMED with the name of the field;
/// REQUEST_TOO_LARGE above limits::kMaxObjects objects, or copies of one object.
absl::StatusOr<PlacedScene> FromProto(const v1::PlacedScene& proto);

/// Returns the sizes of the meshes of all parts, in the order of the parts.
std::vector<v1::MeshSize> MeshSizesOf(const v1::PlacedScene& proto);

/// Stores the meshes in the parts of the scene. REQUIRES: one mesh for each part.
void PutMeshes(std::vector<IndexedMesh> meshes, PlacedScene& scene);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
