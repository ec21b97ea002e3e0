#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "services/texture/algo/paths/engrave_plan.h"

namespace slicefarm::texture {

struct DisplacedOptions {
  double edge_mm = 0.2;  ///< longest edge; triangles are divided until theirs are no longer
};

/// The surface itself with the texture in it, to be printed by other means: triangles divided,
/// their points moved along the normals between those of vertices by what the texture is high
/// there. Within the margin and outside of the mask it stays as it was, and so does a boundary. A
/// surface that was closed is closed again: the texture breaks off at its seam.
///
/// Errors: REQUEST_TOO_LARGE past limits::kMaxTriangles. Cost: O(triangles that come out).
absl::StatusOr<SurfaceMesh> DisplacedMesh(const EngravePlan& plan, const DisplacedOptions& options);

/// As binary STL, or as Wavefront OBJ.
std::string StlBytes(const SurfaceMesh& mesh);
std::string ObjText(const SurfaceMesh& mesh);

}  // namespace slicefarm::texture
