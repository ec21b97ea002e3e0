#include "services/texture/algo/surface/cut_open.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "common/base/disjoint_sets.h"

namespace slicefarm::texture {
namespace {

/// A corner at the vertex `from` and an edge of its triangle there.
struct Spoke {
  int32_t from = 0;
  int32_t to = 0;
  int32_t corner = 0;
};

/// Corners 3t + k, joined around their vertices across all edges but the seam's.
DisjointSets SectorsOf(const SurfaceMesh& mesh, std::span<const SeamEdge> seam) {
  std::vector<Spoke> spokes;
  for (int32_t t = 0; t < static_cast<int32_t>(mesh.triangles.size()); ++t) {
    const auto& triangle = mesh.triangles[t];
    for (int k = 0; k < 3; ++k) {
      for (const int other : {1, 2})
        spokes.push_back({triangle[k], triangle[(k + other) % 3], 3 * t + k});
    }
  }
  std::sort(spokes.begin(), spokes.end(), [](const Spoke& a, const Spoke& b) {
    return std::tie(a.from, a.to, a.corner) < std::tie(b.from, b.to, b.corner);
  });
  DisjointSets sectors(static_cast<int32_t>(3 * mesh.triangles.size()));
  for (size_t i = 1; i < spokes.size(); ++i) {
    const Spoke &a = spokes[i - 1], &b = spokes[i];
    if (a.from != b.from || a.to != b.to) continue;
    const auto [low, high] = std::minmax(a.from, a.to);
    if (!std::binary_search(seam.begin(), seam.end(), SeamEdge{low, high}))
      sectors.Join(a.corner, b.corner);
  }
  return sectors;
}

}  // namespace

OpenedSurface CutOpen(const SurfaceMesh& mesh, std::span<const SeamEdge> seam) {
  OpenedSurface opened{.mesh = mesh, .vertex_of = std::vector<int32_t>(mesh.points_mm.size())};
  std::iota(opened.vertex_of.begin(), opened.vertex_of.end(), 0);
  DisjointSets sectors = SectorsOf(mesh, seam);
  // By vertex, a corner of each of its sectors, and the sector's number.
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
