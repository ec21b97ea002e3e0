#pragma once

#include <cstdint>
#include <vector>

namespace slicefarm {

struct WeightedEdge {
  int32_t a;
  int32_t b;
  int64_t weight;
};

/// A perfect matching of least weight in a graph, and the proof that there is none lighter in it.
struct PerfectMatching {
  std::vector<int32_t> mate;  ///< by node

  /// Whether the proof holds with this edge too: whether it could make the matching no lighter.
  bool Proves(const WeightedEdge& edge) const;

  /// Set by LightestPerfectMatching: duals of nodes, and of the odd sets that hold them.
  struct OddSet {
    int32_t number;
    int64_t dual;
  };
  int64_t dual_scale = 1;
  std::vector<int64_t> node_dual;             ///< by node
  std::vector<std::vector<OddSet>> odd_sets;  ///< by node, in order of their numbers
};

/// REQUIRES: the graph on 0 .. size - 1 has a perfect matching; |weight| <= 2^56. Cost:
/// O(size * edges * log size). Source: J. Edmonds, "Maximum Matching and a Polyhedron with
/// 0,1-Vertices" (1965), by the LEMON library.
PerfectMatching LightestPerfectMatching(int32_t size, const std::vector<WeightedEdge>& edges);

}  // namespace slicefarm
