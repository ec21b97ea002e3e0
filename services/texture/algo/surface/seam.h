#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "services/texture/algo/surface/disk.h"
#include "services/texture/algo/surface/surface_mesh.h"

namespace slicefarm::texture {

/// Edge given by its two vertices, the lower index first.
using SeamEdge = std::array<int32_t, 2>;

/// Returns the edges along which to cut a surface so that it becomes a disk; holes of the surface
/// stay holes. The edges are sorted. A disk needs no cut.
///
/// All handles are cut along loops through one common vertex, two loops for each handle. A few
/// vertices are tried; the shortest seam is used. A closed surface without handles is cut along
/// shortest paths between its extremities: points far from each other, where a map would be
/// stretched most.
///
/// REQUIRES: `topology` is the result of TopologyOf(mesh). Cost: O(n log n) for each of a fixed
/// number of vertices or extremities; n edges. Source: Erickson and Whittlesey, "Greedy Optimal
/// Homotopy and Homology Generators", SODA 2005.
std::vector<SeamEdge> SeamOf(const SurfaceMesh& mesh, const SurfaceTopology& topology);

}  // namespace slicefarm::texture
