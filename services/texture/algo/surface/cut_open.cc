#include "services/texture/algo/surface/cut_open.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "services/texture/algo/surface/corner_fans.h"

namespace slicefarm::texture {
OpenedSurface CutOpen(const SurfaceMesh& mesh, std::span<const SeamEdge> seam) {
  OpenedSurface opened{.mesh = mesh, .vertex_of = std::vector<int32_t>(mesh.points_mm.size())};
  std::iota(opened.vertex_of.begin(), opened.vertex_of.end(), 0);
  DisjointSets sectors = CornerFans(mesh, seam);
  // For each vertex: one corner of each of its sectors, and the sector's vertex in the opened mesh.
  std::vector<std::vector<std::pair<int32_t, int32_t>>> known(mesh.points_mm.size());
  for (int32_t corner = 0; corner < static_cast<int32_t>(3 * mesh.triangles.size()); ++corner) {
    int32_t& vertex = opened.mesh.triangles[corner / 3][corner % 3];
    auto& here = known[vertex];
    const auto sector = std::find_if(here.begin(), here.end(), [&](const auto& of) {
      return sectors.AreJoined(of.first, corner);
    });
    if (sector != here.end()) {
      vertex = sector->second;
    } else if (here.empty()) {
      here.emplace_back(corner, vertex);
    } else {
      const auto number = static_cast<int32_t>(opened.mesh.points_mm.size());
      here.emplace_back(corner, number);
      opened.mesh.points_mm.push_back(mesh.points_mm[vertex]);
      opened.vertex_of.push_back(vertex);
      vertex = number;
    }
  }
  return opened;
}

}  // namespace slicefarm::texture
