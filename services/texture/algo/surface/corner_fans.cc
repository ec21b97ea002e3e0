#include "services/texture/algo/surface/corner_fans.h"

#include <algorithm>
#include <tuple>
#include <vector>

namespace slicefarm::texture {
namespace {

/// Corner of a triangle at the vertex `from`, and one of the two edges of the corner.
struct Spoke {
  int32_t from = 0;
  int32_t to = 0;
  int32_t corner = 0;
};

}  // namespace

DisjointSets CornerFans(const SurfaceMesh& mesh, std::span<const SeamEdge> seam) {
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

}  // namespace slicefarm::texture
