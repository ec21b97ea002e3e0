#pragma once

#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "services/texture/algo/surface/surface_mesh.h"

namespace slicefarm::texture {

/// Vertices around the surface or around a hole in it, the surface on the left.
using BoundaryLoop = std::vector<int32_t>;

struct SurfaceTopology {
  std::vector<BoundaryLoop> loops;  ///< the longest first
  int64_t handles = 0;              ///< genus: 0 of a sphere, 1 of a torus
};

/// What kind of surface a mesh is.
///
/// Errors: MESH_EMPTY; MESH_NOT_FINITE; MESH_MALFORMED, with the place, for an index beyond the
/// points, a triangle without area, an edge of more than two triangles or of two that are wound
/// against each other, a vertex at which several fans meet, and for several components. Cost: O(n
/// log n) for n triangles.
absl::StatusOr<SurfaceTopology> TopologyOf(const SurfaceMesh& mesh);

/// The boundary of a disk with holes: the loop of the greatest length first, then the holes.
/// Errors: those of TopologyOf; MESH_MALFORMED for a closed surface and one with a handle: see
/// CutOpen.
absl::StatusOr<std::vector<BoundaryLoop>> BoundaryOfDisk(const SurfaceMesh& mesh);

}  // namespace slicefarm::texture
