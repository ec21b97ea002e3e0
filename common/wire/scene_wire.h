#pragma once

#include <span>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/scene/scene.h"
#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm {

/// Objects as clients submit them, and the files to which their parts refer by index.
struct SubmittedScene {
  std::vector<StoredMesh> meshes;  ///< files, each of them once
  std::vector<SceneObject> objects;

  bool operator==(const SubmittedScene&) const = default;
};

/// Converts an object with its parts and copies. `meshes`: files, indexed by MeshRef::file of the
/// parts. A copy that is not printable is left out.
void ToProto(const SceneObject& object, std::span<const StoredMesh> meshes, v1::Object* proto);

/// Converts submitted objects. Errors: REQUEST_MALFORMED with the path to the field, for invalid
/// digests, numbers that are not finite, values given in both possible forms, and objects without a
/// mesh. REQUEST_TOO_LARGE beyond limits::kMaxParts, kMaxHeightRanges and kMaxObjects. The errors
/// of FromProto(v1::Placement).
absl::StatusOr<SubmittedScene> FromProto(
    const google::protobuf::RepeatedPtrField<v1::Object>& objects);

}  // namespace slicefarm
