#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/model/mesh.h"
#include "common/model/scene.h"
#include "common/model/slicing_options.h"
#include "services/slicing/algo/mesh_io/mesh_source.h"

namespace slicefarm::slicing {

/// Puts the copies of a scene on as many beds as it takes (arrange.h): what one job each can print.
///
/// Copies with a place keep it and are on the first plate; each other copy gets one on some plate.
/// Plates are never empty, and keep the objects' order. `files`: those that the parts refer to.
/// Errors: those of PartMeshes and Arrange; OUT_OF_BUILD_VOLUME, naming objects that are too large
/// for an empty bed.
absl::StatusOr<std::vector<std::vector<SceneObject>>> PutOnPlates(
    std::vector<MeshFile> files, const std::vector<SceneObject>& objects,
    const SlicingOptions& options, const MeshSource& source, const CancelToken& cancel);

}  // namespace slicefarm::slicing
