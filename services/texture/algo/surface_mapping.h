#pragma once

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "processes/engrave/model/engrave_input.h"

namespace slicefarm::texture {

/// Steps 0 to 7 of the README: what the surface is, its seam, and its map. Errors: those of
/// TopologyOf and Flatten; MESH_TOO_LARGE past limits::kMaxSurfaceTriangles.
absl::StatusOr<MappedSurface> MapSurface(const SurfaceInput& surface,
                                         const CancelToken& cancel = {});

}  // namespace slicefarm::texture
