#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "services/texture/algo/surface/seam.h"
#include "services/texture/algo/surface/surface_mesh.h"

namespace slicefarm::texture {

struct OpenedSurface {
  SurfaceMesh mesh;                ///< triangles in the order they had
  std::vector<int32_t> vertex_of;  ///< the vertex that each vertex was
};

/// The surface cut along edges: a vertex becomes one for each sector that they leave around it. The
/// first sector keeps the vertex's number. `seam` is sorted. Cost: O(n log n) for n triangles.
OpenedSurface CutOpen(const SurfaceMesh& mesh, std::span<const SeamEdge> seam);

}  // namespace slicefarm::texture
