#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace slicefarm::slicing {

/// Corner indices of a face, counter-clockwise seen from outside. Half-edge 3 f + i of face f runs
/// from its corner i to its corner (i + 1) % 3.
using Triangle = std::array<uint32_t, 3>;

/// Value for a half-edge without a twin.
inline constexpr uint32_t kNoTwin = UINT32_MAX;

/// Returns the face of a half-edge.
inline uint32_t FaceOf(uint32_t half_edge) { return half_edge / 3; }
/// Returns the vertex where a half-edge starts.
inline uint32_t OriginOf(std::span<const Triangle> triangles, uint32_t half_edge) {
  return triangles[half_edge / 3][half_edge % 3];
}
/// Returns the vertex where a half-edge ends.
inline uint32_t TargetOf(std::span<const Triangle> triangles, uint32_t half_edge) {
  return triangles[half_edge / 3][(half_edge % 3 + 1) % 3];
}

/// Table of half-edges that belong to the same edge of a mesh.
struct EdgeTable {
  /// Twin of each half-edge: the other half-edge of its edge, if the edge has exactly two faces.
  /// kNoTwin at open edges and at fans; PairFans pairs fans later.
  std::vector<uint32_t> twins;
  /// Half-edges of fans (edges with more than two faces), fan after fan. Fan i has the range
  /// [fan_starts[i], fan_starts[i + 1]).
  std::vector<uint32_t> fans;
  std::vector<uint32_t> fan_starts = {0};
  int64_t open_edges = 0;
  /// Number of edges with two faces that traverse the edge in the same direction: one of the faces
  /// is flipped.
  int64_t conflicts = 0;

  /// Returns the number of fans.
  int64_t fan_count() const { return static_cast<int64_t>(fan_starts.size()) - 1; }
};

/// Builds the table by one counting sort of the half-edges by their lower vertex and a small sort
/// by the upper vertex in each bucket. REQUIRES: no face has two equal corners; all corners <
/// vertex_count. Cost: O(n) for bounded vertex degrees; 24 bytes per triangle of temporary memory,
/// 12 for the result.
EdgeTable BuildEdgeTable(std::span<const Triangle> triangles, size_t vertex_count);

}  // namespace slicefarm::slicing
