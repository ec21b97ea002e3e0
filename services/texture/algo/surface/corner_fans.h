#pragma once

#include <span>

#include "common/base/disjoint_sets.h"
#include "services/texture/algo/surface/seam.h"
#include "services/texture/algo/surface/surface_mesh.h"

namespace slicefarm::texture {

/// Divides the triangle corners at each vertex into connected sets. Two corners are connected if
/// their triangles share an edge at the vertex that is not in the seam. So a fan of triangles is
/// one set. Corner k of triangle t has the index 3t + k. `seam` is sorted. Cost: O(n log n) for n
/// triangles.
DisjointSets CornerFans(const SurfaceMesh& mesh, std::span<const SeamEdge> seam);

}  // namespace slicefarm::texture
