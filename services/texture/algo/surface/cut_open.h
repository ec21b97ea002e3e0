#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "services/texture/algo/surface/seam.h"
#include "services/texture/algo/surface/surface_mesh.h"

namespace slicefarm::texture {

/// Surface after cutting.
struct OpenedSurface {
  SurfaceMesh mesh;                ///< triangles in their original order
  std::vector<int32_t> vertex_of;  ///< vertex before the cut, per vertex of `mesh`
};

/// Cuts a surface along edges. A vertex becomes one vertex for each sector that the cuts leave
/// around it; the first sector keeps the vertex's index. `seam` is sorted. Cost: O(n log n) for n
/// triangles.
OpenedSurface CutOpen(const SurfaceMesh& mesh, std::span<const SeamEdge> seam);

}  // namespace slicefarm::texture
