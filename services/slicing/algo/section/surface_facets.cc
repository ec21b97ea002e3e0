#include "services/slicing/algo/section/surface_facets.h"

#include <algorithm>
#include <numeric>

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

/// Layers that a face reaches, from `first` to before `end`.
struct LayerRange {
  size_t first = 0, end = 0;
};

LayerRange LayersOf(const std::array<Vertex, 3>& face, std::span<const LayerPlane> planes) {
  const auto [low, high] = std::minmax({face[0].z, face[1].z, face[2].z});
  const auto first = std::ranges::partition_point(
      planes, [low = low](const LayerPlane& plane) { return plane.frame.print_z_nm < low; });
  const auto end = std::partition_point(
      first, planes.end(),
      [high = high](const LayerPlane& plane) { return BottomOf(plane) <= high; });
  return {static_cast<size_t>(first - planes.begin()), static_cast<size_t>(end - planes.begin())};
}

/// Calls visit(face) for each face of the meshes' upper sides.
template <typename Visit>
void ForEachUpperFace(std::span<const IndexedMesh* const> meshes, const Visit& visit) {
  for (const IndexedMesh* mesh : meshes) {
    for (const auto& corners : mesh->triangles) {
      const std::array<Vertex, 3> face = {mesh->vertices[corners[0]], mesh->vertices[corners[1]],
                                          mesh->vertices[corners[2]]};
      if (FacesUp(face)) visit(face);
    }
  }
}

}  // namespace

std::vector<int64_t> CountFacets(std::span<const IndexedMesh* const> meshes,
                                 std::span<const LayerPlane> planes) {
  std::vector<int64_t> counts(planes.size() + 1);  // differences between neighbour layers
  ForEachUpperFace(meshes, [&](const std::array<Vertex, 3>& face) {
    const auto [first, end] = LayersOf(face, planes);
    ++counts[first], --counts[end];
  });
  std::partial_sum(counts.begin(), counts.end(), counts.begin());
  counts.pop_back();
  return counts;
}

std::vector<std::vector<SurfaceFacet>> FacetsOfLayers(std::span<const IndexedMesh* const> meshes,
                                                      std::span<const LayerPlane> planes,
                                                      std::span<const int64_t> counts) {
  std::vector<std::vector<SurfaceFacet>> facets(planes.size());
  for (size_t i = 0; i < planes.size(); ++i) facets[i].reserve(static_cast<size_t>(counts[i]));
  ForEachUpperFace(meshes, [&](const std::array<Vertex, 3>& face) {
    const auto [first, end] = LayersOf(face, planes);
    for (size_t i = first; i < end; ++i)
      facets[i].push_back(FacetAt(face, planes[i].frame.print_z_nm));
  });
  return facets;
}

}  // namespace slicefarm::slicing
