#pragma once

#include <memory>

#include "common/stage/plates.h"
#include "services/slicing/algo/mesh_reader/mesh_source.h"

namespace slicefarm::slicing {

/// Returns the arranging stage that runs in this program (arrange.h). `source` reads its meshes.
/// Errors: any error of PartMeshes and Arrange; OUT_OF_BUILD_VOLUME with the names of the objects
/// that are too large for an empty bed.
std::unique_ptr<ArrangingStage> MakeLocalArranging(
    std::unique_ptr<const MeshSource> source = MakeDirectMeshSource());

}  // namespace slicefarm::slicing
