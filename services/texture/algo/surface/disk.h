#pragma once

#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "services/texture/algo/surface/surface_mesh.h"

namespace slicefarm::texture {

/// Vertices around the surface or around a hole in it, the surface on the left.
using BoundaryLoop = std::vector<int32_t>;

/// The boundary of a disk with holes: the loop of the greatest length first, then the holes.
///
/// Errors: MESH_EMPTY; MESH_NOT_FINITE; MESH_MALFORMED, with the place, for an index beyond the
/// points, a triangle without area, an edge of more than two triangles or of two that are wound
/// against each other, a vertex at which several fans meet, several components, a closed surface,
/// and a handle (genus over 0). Cost: O(n log n) for n triangles.
absl::StatusOr<std::vector<BoundaryLoop>> BoundaryOfDisk(const SurfaceMesh& mesh);

}  // namespace slicefarm::texture
