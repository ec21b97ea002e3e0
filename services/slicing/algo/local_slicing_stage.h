#pragma once

#include <memory>

#include "common/stage/slicing_stage.h"
#include "common/stage/stages.h"
#include "services/slicing/algo/mesh_reader/mesh_source.h"

namespace slicefarm::slicing {

/// Returns the slicing stage that runs in this program. `source` reads its meshes. README.md lists
/// the steps.
///
/// Errors: any error of PrepareObjects, LayerPlanes, Sweep and RenderThumbnail; NOTHING_TO_PRINT if
/// no layer has an outline; Cancelled.
std::unique_ptr<SlicingStage> MakeLocalSlicing(
    std::unique_ptr<const MeshSource> source = MakeDirectMeshSource());

}  // namespace slicefarm::slicing
