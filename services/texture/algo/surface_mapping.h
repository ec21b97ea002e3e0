#pragma once

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "processes/engrave/model/engrave_input.h"

namespace slicefarm::texture {

/// Maps a surface into the plane (steps 0 to 7 of the README): topology, seam and flat map. Errors:
/// any error of TopologyOf and Flatten; MESH_TOO_LARGE above limits::kMaxSurfaceTriangles, or if
/// the flat map has too many points for one message.
absl::StatusOr<MappedSurface> MapSurface(const SurfaceInput& surface,
                                         const CancelToken& cancel = {});

}  // namespace slicefarm::texture
