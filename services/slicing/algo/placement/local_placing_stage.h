#pragma once

#include <memory>

#include "common/stage/slicing_stage.h"
#include "common/stage/stages.h"
#include "services/slicing/algo/mesh_reader/mesh_source.h"

namespace slicefarm::slicing {

/// Returns the placing stage that runs in this program (prepared_object.h). `source` reads its
/// meshes.
std::unique_ptr<PlacingStage> MakeLocalPlacing(
    std::unique_ptr<const MeshSource> source = MakeDirectMeshSource());

}  // namespace slicefarm::slicing
