#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace slicefarm::slicing {

/// Corner indices of a face, counter-clockwise seen from outside. Half-edge 3 f + i of face f runs
/// from its corner i to its corner (i + 1) % 3.
using Triangle = std::array<uint32_t, 3>;

inline constexpr uint32_t kNoTwin = UINT32_MAX;

inline uint32_t FaceOf(uint32_t half_edge) { return half_edge / 3; }
inline uint32_t OriginOf(std::span<const Triangle> triangles, uint32_t half_edge) {
  return triangles[half_edge / 3][half_edge % 3];
}
inline uint32_t TargetOf(std::span<const Triangle> triangles, uint32_t half_edge) {
  return triangles[half_edge / 3][(half_edge % 3 + 1) % 3];
}

/// Which half-edges lie on the same edge.
struct EdgeTable {
  /// The other half-edge of an edge with exactly two faces; kNoTwin at open edges and fans.
  std::vector<uint32_t> twins;
  /// Half-edges of edges with more than two faces, edge after edge; fan i is [fan_starts[i],
  /// fan_starts[i + 1]).
  std::vector<uint32_t> fans;
  std::vector<uint32_t> fan_starts = {0};
  int64_t open_edges = 0;
  /// Edges whose two faces run along it in the same direction: one of them is flipped.
  int64_t conflicts = 0;

  int64_t fan_count() const { return static_cast<int64_t>(fan_starts.size()) - 1; }
};

/// Finds them by one counting sort of the half-edges by their lower vertex and a small sort by the
/// upper one within. REQUIRES: no face has two equal corners; all corners < vertex_count. Cost:
/// O(n) for bounded vertex degrees; 24 bytes a triangle while it works, 12 for the result.
EdgeTable BuildEdgeTable(std::span<const Triangle> triangles, size_t vertex_count);

}  // namespace slicefarm::slicing
