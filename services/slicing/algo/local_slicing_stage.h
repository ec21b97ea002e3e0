#pragma once

#include <memory>

#include "common/stage/stages.h"
#include "services/slicing/algo/mesh_io/mesh_source.h"

namespace slicefarm::slicing {

/// The slicing stage in this process, its meshes read by `source`; README.md lists its steps.
/// Errors: those of the source, PlaceMesh, CheckBuildVolume, LayerPlanes, Sweep and
/// RenderThumbnail, those of one file with its number (from 0, also as `file` in the metadata) and
/// its name in the message where there are several; NOTHING_TO_PRINT if no layer has an outline;
/// REQUEST_MALFORMED for files without placements; Cancelled.
std::unique_ptr<SlicingStage> MakeLocalSlicing(
    std::unique_ptr<const MeshSource> source = MakeDirectMeshSource());

}  // namespace slicefarm::slicing
