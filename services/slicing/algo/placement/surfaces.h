#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/stage/slice_input.h"
#include "common/stage/stages.h"
#include "processes/engrave/model/surface_mesh.h"
#include "services/slicing/algo/mesh_reader/mesh_source.h"

namespace slicefarm::slicing {

/// The objects as doubles, as PlacingStage::ReadSurfaces says. Errors: those of PartMeshes::Take
/// too.
absl::StatusOr<std::vector<SurfaceMesh>> SurfacesOf(SliceInput input, const MeshSource& source,
                                                    const CancelToken& cancel);

}  // namespace slicefarm::slicing
