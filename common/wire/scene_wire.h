#pragma once

#include <span>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/scene/scene.h"
#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm {

/// Objects as clients submit them, and the files that their parts refer to by index.
struct SubmittedScene {
  std::vector<StoredMesh> meshes;  ///< each once
  std::vector<SceneObject> objects;

  bool operator==(const SubmittedScene&) const = default;
};

/// An object of parts, its copies among them. `meshes`: by the parts' MeshRef::file. A copy that is
/// not printable is left out.
void ToProto(const SceneObject& object, std::span<const StoredMesh> meshes, v1::Object* proto);

/// Errors: REQUEST_MALFORMED with the way to the field: digests that are none, numbers that are not
/// finite, what is given in both ways, an object without a mesh; those of FromProto(v1::Placement);
/// REQUEST_TOO_LARGE beyond limits::kMaxParts, kMaxHeightRanges and kMaxObjects.
absl::StatusOr<SubmittedScene> FromProto(
    const google::protobuf::RepeatedPtrField<v1::Object>& objects);

}  // namespace slicefarm
