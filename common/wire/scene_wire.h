#pragma once

#include <span>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/scene/scene.h"
#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm {

/// Objects that a client submits, and the mesh files of their parts. A part refers to a file by its
/// index in `meshes`.
struct SubmittedScene {
  std::vector<StoredMesh> meshes;  ///< mesh files without duplicates
  std::vector<SceneObject> objects;

  bool operator==(const SubmittedScene&) const = default;
};

/// Converts an object with its parts and copies. `meshes`: files, indexed by MeshRef::file of the
/// parts. Copies that must not be printed are left out.
void ToProto(const SceneObject& object, std::span<const StoredMesh> meshes, v1::Object* proto);

/// Converts submitted objects. Errors:
/// - REQUEST_MALFORMED with the path to the field, for invalid digests, numbers that are not
///   finite, values that are given in two forms at once, and objects without a mesh;
/// - REQUEST_TOO_LARGE beyond limits::kMaxParts, kMaxHeightRanges and kMaxObjects;
/// - any error of FromProto(v1::Placement).
absl::StatusOr<SubmittedScene> FromProto(
    const google::protobuf::RepeatedPtrField<v1::Object>& objects);

}  // namespace slicefarm
