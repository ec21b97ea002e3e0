#pragma once

#include <span>
#include <vector>

#include "common/model/layers/surface_facet.h"
#include "common/model/scene/mesh.h"
#include "services/slicing/algo/section/layer_heights.h"

namespace slicefarm::slicing {

/// Returns the faces of the meshes' upper sides that reach into each layer, indexed by layer. A
/// face that reaches into several layers is in each of them, with its heights relative to the
/// layer's top. Vertical faces and faces of the lower side are left out. Cost: O(faces + result).
std::vector<std::vector<SurfaceFacet>> FacetsOfLayers(std::span<const IndexedMesh* const> meshes,
                                                      std::span<const LayerPlane> planes);

}  // namespace slicefarm::slicing
