#pragma once

#include <cstdint>
#include <vector>

namespace slicefarm {

/// Edge between the nodes a and b.
struct WeightedEdge {
  int32_t a;
  int32_t b;
  int64_t weight;
};

/// Perfect matching of minimum weight in a graph, with the proof that no perfect matching is
/// lighter.
struct PerfectMatching {
  std::vector<int32_t> mate;  ///< partner of each node

  /// Returns true if the proof also holds with this edge added: the edge does not allow a lighter
  /// matching.
  bool Proves(const WeightedEdge& edge) const;

  /// Part of the proof, set by LightestPerfectMatching: odd set of nodes with its dual variable.
  struct OddSet {
    int32_t number;
    int64_t dual;
  };
  int64_t dual_scale = 1;
  std::vector<int64_t> node_dual;  ///< dual variable of each node
  /// Odd sets that contain each node, ordered by their numbers.
  std::vector<std::vector<OddSet>> odd_sets;
};

/// Returns a perfect matching of minimum weight. REQUIRES: the graph on 0 .. size - 1 has a perfect
/// matching; |weight| <= 2^56. Cost: O(size * edges * log size). Source: J. Edmonds, "Maximum
/// Matching and a Polyhedron with 0,1-Vertices" (1965), by the LEMON library.
PerfectMatching LightestPerfectMatching(int32_t size, const std::vector<WeightedEdge>& edges);

}  // namespace slicefarm
