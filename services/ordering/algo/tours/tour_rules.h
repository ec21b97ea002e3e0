#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace slicefarm::ordering {

/// Nodes in the order of visiting. The tour returns from the last node to the first.
using Tour = std::vector<int32_t>;

/// Pair of nodes. As an edge, a and b are consecutive; as an order rule, a is visited before b.
struct NodePair {
  int32_t a = 0;
  int32_t b = 0;

  friend bool operator==(const NodePair&, const NodePair&) = default;
};

/// Rules for every tour, in addition to visiting each node once.
struct TourRules {
  /// Edges that every tour must contain: open chains, or one ring of all nodes.
  std::vector<NodePair> fixed;
  /// Order rules: a is visited before b on the path from `first` to `last`. A leg that may not be
  /// reversed is a fixed edge plus the rule that its start is before its end.
  std::vector<NodePair> before;
  /// First node of the path on which `before` defines the order; `last` is its last node. If
  /// `before` is not empty, {last, first} must be a fixed edge.
  int32_t first = 0;
  int32_t last = 0;
};

/// Fixed edges, indexed by node.
class FixedEdges {
 public:
  static constexpr int32_t kNone = -1;

  /// Indexes the edges of a graph with `size` nodes. REQUIRES: at most two edges per node.
  FixedEdges(int32_t size, std::span<const NodePair> edges);

  /// Returns true if ab is a fixed edge.
  bool Has(int32_t a, int32_t b) const {
    const auto& mates = mates_[static_cast<size_t>(a)];
    return mates[0] == b || mates[1] == b;
  }
  /// Returns the up to two nodes that a fixed edge joins to this node. Unused entries are kNone.
  const std::array<int32_t, 2>& Of(int32_t node) const { return mates_[static_cast<size_t>(node)]; }

 private:
  std::vector<std::array<int32_t, 2>> mates_;
};

/// Returns the tour with nodes moved so that it contains all fixed edges. A whole chain of fixed
/// edges is moved to the position of its node that `tour` visits first. The chain begins with the
/// end that is nearer to that node.
Tour WithFixedEdges(const Tour& tour, const FixedEdges& fixed);

/// Returns true if the tour visits each node of 0 .. size - 1 once and keeps the rules. Cost: O(n),
/// n nodes and rules.
bool Keeps(const Tour& tour, int32_t size, const TourRules& rules);

}  // namespace slicefarm::ordering
