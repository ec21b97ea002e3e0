#include "services/slicing/algo/section/surface_facets.h"

#include <algorithm>

#include "common/geometry/point.h"

namespace slicefarm::slicing {
namespace {

Coord BottomOf(const LayerPlane& plane) { return plane.frame.print_z_nm - plane.frame.height_nm; }

SurfaceFacet FacetAt(const std::array<Vertex, 3>& face, Coord top_nm) {
  SurfaceFacet facet;
  for (size_t i = 0; i < face.size(); ++i) {
    facet.corners[i] = {face[i].x, face[i].y};
    facet.up_nm[i] = face[i].z - top_nm;
  }
  return facet;
}

bool FacesUp(const std::array<Vertex, 3>& face) {
  const Point a{face[0].x, face[0].y}, b{face[1].x, face[1].y}, c{face[2].x, face[2].y};
  return Cross(b - a, c - a) > 0;
}

}  // namespace

std::vector<std::vector<SurfaceFacet>> FacetsOfLayers(std::span<const IndexedMesh* const> meshes,
                                                      std::span<const LayerPlane> planes) {
  std::vector<std::vector<SurfaceFacet>> facets(planes.size());
  for (const IndexedMesh* mesh : meshes) {
    for (const auto& corners : mesh->triangles) {
      const std::array<Vertex, 3> face = {mesh->vertices[corners[0]], mesh->vertices[corners[1]],
                                          mesh->vertices[corners[2]]};
      if (!FacesUp(face)) continue;
      const auto [low, high] = std::minmax({face[0].z, face[1].z, face[2].z});
      auto plane = std::ranges::partition_point(
          planes, [low = low](const LayerPlane& layer) { return layer.frame.print_z_nm < low; });
      for (; plane != planes.end() && BottomOf(*plane) <= high; ++plane)
        facets[static_cast<size_t>(plane - planes.begin())].push_back(
            FacetAt(face, plane->frame.print_z_nm));
    }
  }
  return facets;
}

}  // namespace slicefarm::slicing
