#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "services/texture/algo/paths/engrave_plan.h"

namespace slicefarm::texture {

/// Options for DisplacedMesh.
struct DisplacedOptions {
  double edge_mm = 0.2;  ///< longest edge; triangles are divided until no edge is longer
};

/// Returns the surface with the texture applied, for manufacturing by other methods. Triangles are
/// divided, and their points are moved by the texture's height along interpolated vertex normals.
/// Points within the margin, outside of the mask and at a boundary are not moved. A closed surface
/// that was cut open for the map is closed again: at the cut, points are not moved.
///
/// Errors: REQUEST_TOO_LARGE above limits::kMaxTriangles. Cost: O(number of resulting triangles).
absl::StatusOr<SurfaceMesh> DisplacedMesh(const EngravePlan& plan, const DisplacedOptions& options);

/// Returns a mesh as binary STL.
std::string StlBytes(const SurfaceMesh& mesh);
/// Returns a mesh as Wavefront OBJ.
std::string ObjText(const SurfaceMesh& mesh);

}  // namespace slicefarm::texture
