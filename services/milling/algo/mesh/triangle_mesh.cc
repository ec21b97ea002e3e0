#include "services/milling/algo/mesh/triangle_mesh.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace slicefarm::milling {
namespace {

/// Side of a triangle with its ends, the lower index first.
struct MeshSide {
  uint64_t ends = 0;
  uint32_t triangle = 0;
  uint32_t corner = 0;
};

std::vector<MeshSide> SidesOf(const TriangleMesh& mesh) {
  std::vector<MeshSide> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (uint32_t k = 0; k < 3; ++k) {
      const uint64_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      sides.push_back({std::min(a, b) << 32 | std::max(a, b), t, k});
    }
  }
  return sides;
}

}  // namespace

MeshEdges EdgesOf(const TriangleMesh& mesh) {
  std::vector<MeshSide> sides = SidesOf(mesh);
  std::sort(sides.begin(), sides.end(), [](const MeshSide& a, const MeshSide& b) {
    return std::tie(a.ends, a.triangle, a.corner) < std::tie(b.ends, b.triangle, b.corner);
  });
  MeshEdges edges;
  edges.of_triangle.resize(mesh.triangles.size());
  for (size_t i = 0; i < sides.size(); ++i) {
    if (i == 0 || sides[i].ends != sides[i - 1].ends) {
      uint32_t a = static_cast<uint32_t>(sides[i].ends >> 32);
      uint32_t b = static_cast<uint32_t>(sides[i].ends);
      if (ByCoordinates(mesh.points_mm[b], mesh.points_mm[a])) std::swap(a, b);
      edges.ends.push_back({a, b});
    }
    edges.of_triangle[sides[i].triangle][sides[i].corner] =
        static_cast<uint32_t>(edges.ends.size() - 1);
  }
  return edges;
}

}  // namespace slicefarm::milling
