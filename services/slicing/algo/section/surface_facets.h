#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/model/layers/surface_facet.h"
#include "common/model/scene/mesh.h"
#include "services/slicing/algo/section/layer_heights.h"

namespace slicefarm::slicing {

/// Returns the number of facets that FacetsOfLayers returns for each layer. Cost: O(n log l), n
/// faces and l layers.
std::vector<int64_t> CountFacets(std::span<const IndexedMesh* const> meshes,
                                 std::span<const LayerPlane> planes);

/// Returns the faces of the meshes' upper sides that reach into each layer, indexed by layer. A
/// face that reaches into several layers is in each of them, with its heights relative to the
/// layer's top. Vertical faces and faces of the lower side are left out. `counts`: result of
/// CountFacets. Cost: O(n log l + result).
std::vector<std::vector<SurfaceFacet>> FacetsOfLayers(std::span<const IndexedMesh* const> meshes,
                                                      std::span<const LayerPlane> planes,
                                                      std::span<const int64_t> counts);

}  // namespace slicefarm::slicing
