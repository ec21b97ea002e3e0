#pragma once

#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "services/texture/algo/surface/surface_mesh.h"

namespace slicefarm::texture {

/// Boundary loop as vertices: around the surface or around a hole in it, with the surface on the
/// left.
using BoundaryLoop = std::vector<int32_t>;

/// Topology of a surface.
struct SurfaceTopology {
  std::vector<BoundaryLoop> loops;  ///< boundary loops, the longest one first
  int64_t handles = 0;              ///< genus: 0 for a sphere, 1 for a torus
};

/// Returns the topology of a surface.
///
/// Errors: MESH_EMPTY; MESH_NOT_FINITE; and MESH_MALFORMED, with the position, for
/// - an index beyond the points;
/// - a triangle without area;
/// - an edge with more than two triangles, or with two of opposite orientation;
/// - a vertex at which several fans meet;
/// - several components.
///
/// Cost: O(n log n) for n triangles.
absl::StatusOr<SurfaceTopology> TopologyOf(const SurfaceMesh& mesh);

/// Returns the boundary of a disk with holes: the longest loop first, then the holes. Errors: any
/// error of TopologyOf; MESH_MALFORMED for a closed surface and for a surface with a handle, which
/// require CutOpen.
absl::StatusOr<std::vector<BoundaryLoop>> BoundaryOfDisk(const SurfaceMesh& mesh);

}  // namespace slicefarm::texture
