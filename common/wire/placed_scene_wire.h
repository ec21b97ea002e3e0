#pragma once

#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/scene/placed_scene.h"
#include "common/wire/mesh_pieces.h"
#include "slicefarm/v1/slicing.pb.h"

namespace slicefarm {

/// All of a scene but its meshes, which follow in pieces, part by part.
absl::Status ToProto(const PlacedScene& scene, v1::PlacedScene* proto);
/// The scene without its meshes. Errors: REQUEST_MALFORMED naming the field; REQUEST_TOO_LARGE.
absl::StatusOr<PlacedScene> FromProto(const v1::PlacedScene& proto);

/// Of all parts, in their order.
std::vector<v1::MeshSize> MeshSizesOf(const v1::PlacedScene& proto);

/// Puts the meshes where they belong. REQUIRES: one for each part.
void PutMeshes(std::vector<IndexedMesh> meshes, PlacedScene& scene);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
