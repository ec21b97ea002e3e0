#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace slicefarm::ordering {

/// Nodes in the order of visiting; from the last it goes back to the first.
using Tour = std::vector<int32_t>;

struct NodePair {
  int32_t a = 0;
  int32_t b = 0;

  friend bool operator==(const NodePair&, const NodePair&) = default;
};

/// What every tour must keep, besides visiting each node once.
struct TourRules {
  /// Edges of the tour: open chains, or one ring of all nodes.
  std::vector<NodePair> fixed;
  /// a is visited before b on the way from `first` to `last`. A stretch that may not be reversed is
  /// a fixed edge with its start before its end.
  std::vector<NodePair> before;
  /// The ends of the way, for `before`: if there is any, {last, first} must be a fixed edge.
  int32_t first = 0;
  int32_t last = 0;
};

/// The fixed edges, by node.
class FixedEdges {
 public:
  static constexpr int32_t kNone = -1;

  FixedEdges(int32_t size, std::span<const NodePair> edges);

  bool Has(int32_t a, int32_t b) const {
    const auto& mates = mates_[static_cast<size_t>(a)];
    return mates[0] == b || mates[1] == b;
  }
  /// The nodes that are joined to this one; kNone where there are fewer than two.
  const std::array<int32_t, 2>& Of(int32_t node) const { return mates_[static_cast<size_t>(node)]; }

 private:
  std::vector<std::array<int32_t, 2>> mates_;
};

/// The tour with its nodes moved so that all fixed edges are in it: a chain comes as a whole where
/// the first of its nodes stood, from the end that is nearer to that node.
Tour WithFixedEdges(const Tour& tour, const FixedEdges& fixed);

/// Whether the tour visits every node of 0 .. size - 1 once and keeps the rules. Cost: O(n).
bool Keeps(const Tour& tour, int32_t size, const TourRules& rules);

}  // namespace slicefarm::ordering
