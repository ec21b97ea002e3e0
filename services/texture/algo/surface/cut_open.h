#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "services/texture/algo/surface/seam.h"
#include "services/texture/algo/surface/surface_mesh.h"

namespace slicefarm::texture {

/// Surface after cutting along a seam. Vertices on the seam exist more than once.
struct OpenedSurface {
  SurfaceMesh mesh;                ///< triangles in their original order
  std::vector<int32_t> vertex_of;  ///< index of each vertex of `mesh` in the surface before the cut
};

/// Cuts a surface along the edges `seam`, which are sorted. The cuts divide the triangles around a
/// vertex into sectors. The first sector keeps the vertex's index; each further sector gets a copy
/// of the vertex. Cost: O(n log n) for n triangles.
OpenedSurface CutOpen(const SurfaceMesh& mesh, std::span<const SeamEdge> seam);

}  // namespace slicefarm::texture
