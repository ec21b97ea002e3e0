#pragma once

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "processes/engrave/model/surface_mesh.h"
#include "slicefarm/v1/surface.pb.h"

namespace slicefarm {

/// Converts a surface. Errors: REQUEST_MALFORMED for numbers that are not finite, for counts that
/// are not multiples of three, and for point indices out of range; MESH_TOO_LARGE above
/// limits::kMaxSurfaceTriangles.
absl::Status ToProto(const SurfaceMesh& mesh, v1::SurfaceMesh* proto);
absl::StatusOr<SurfaceMesh> FromProto(const v1::SurfaceMesh& proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
