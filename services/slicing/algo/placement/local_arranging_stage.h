#pragma once

#include <memory>

#include "common/stage/plates.h"
#include "services/slicing/algo/mesh_reader/mesh_source.h"

namespace slicefarm::slicing {

/// The arranging stage in this process (arrange.h), its meshes read by `source`.
/// Errors: those of PartMeshes and Arrange; OUT_OF_BUILD_VOLUME, naming objects that are too large
/// for an empty bed.
std::unique_ptr<ArrangingStage> MakeLocalArranging(
    std::unique_ptr<const MeshSource> source = MakeDirectMeshSource());

}  // namespace slicefarm::slicing
