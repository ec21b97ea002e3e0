#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/stage/slice_input.h"
#include "common/stage/stages.h"
#include "processes/engrave/model/surface_mesh.h"
#include "services/slicing/algo/mesh_reader/mesh_source.h"

namespace slicefarm::slicing {

/// Returns the objects as surfaces with double coordinates, as PlacingStage::ReadSurfaces
/// specifies. Errors: as PlacingStage::ReadSurfaces, and any error of PartMeshes::Take.
absl::StatusOr<std::vector<SurfaceMesh>> SurfacesOf(SliceInput input, const MeshSource& source,
                                                    const CancelToken& cancel);

}  // namespace slicefarm::slicing
