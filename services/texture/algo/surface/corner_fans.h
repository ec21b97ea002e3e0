#pragma once

#include <span>

#include "common/base/disjoint_sets.h"
#include "services/texture/algo/surface/seam.h"
#include "services/texture/algo/surface/surface_mesh.h"

namespace slicefarm::texture {

/// Corners, 3t + k of triangle t, joined around their vertices across all edges but the seam's: a
/// fan of triangles is one set. `seam` is sorted. Cost: O(n log n) for n triangles.
DisjointSets CornerFans(const SurfaceMesh& mesh, std::span<const SeamEdge> seam);

}  // namespace slicefarm::texture
