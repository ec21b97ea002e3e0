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

/// Perfect matching of minimum weight in a graph: each node has exactly one partner. Also contains
/// a proof (dual variables) that no perfect matching has a smaller weight.
struct PerfectMatching {
  std::vector<int32_t> mate;  ///< partner of each node

  /// Returns true if the proof is also valid for the graph with this additional edge. The matching
  /// is then still of minimum weight.
  bool Proves(const WeightedEdge& edge) const;

  /// Set of an odd number of nodes, and its dual variable. OddSets are part of the proof; only
  /// LightestPerfectMatching makes them.
  struct OddSet {
    int32_t number;
    int64_t dual;
  };
  int64_t dual_scale = 1;
  /// Dual variable of each node, for weights multiplied by `dual_scale`.
  std::vector<int64_t> node_dual;
  /// odd sets that contain each node, indexed by node; each list is sorted by OddSet::number
  std::vector<std::vector<OddSet>> odd_sets;
};

/// Returns a perfect matching of minimum weight. `size`: number of nodes, which have the indices 0
/// to size - 1. REQUIRES: the graph has a perfect matching; |weight| <= 2^56. Cost: O(size * edges
/// * log size). Source: J. Edmonds, "Maximum Matching and a Polyhedron with 0,1-Vertices" (1965),
/// by the LEMON library.
PerfectMatching LightestPerfectMatching(int32_t size, const std::vector<WeightedEdge>& edges);

}  // namespace slicefarm
