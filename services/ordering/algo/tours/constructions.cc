#include "services/ordering/algo/tours/constructions.h"

#include <algorithm>
#include <tuple>

#include "common/base/disjoint_sets.h"

namespace slicefarm::ordering {
namespace {

constexpr int32_t kNone = FixedEdges::kNone;

/// Chains of nodes that are joined step by step into a tour.
class Pieces {
 public:
  explicit Pieces(int32_t size)
      : links_(static_cast<size_t>(size), {kNone, kNone}), pieces_(size) {}

  bool IsEnd(int32_t node) const { return links_[static_cast<size_t>(node)][1] == kNone; }

  /// Joins two nodes, unless one of them would have three edges or the edges would close a ring.
  void Join(int32_t a, int32_t b) {
    if (!IsEnd(a) || !IsEnd(b)) return;
    if (!pieces_.Join(a, b)) return;
    Link(a, b);
    Link(b, a);
  }

  /// Returns the nodes of a chain, from the given end to the other end.
  Tour From(int32_t end) const {
    Tour piece = {end};
    int32_t before = kNone;
    for (int32_t at = end;;) {
      const auto& links = links_[static_cast<size_t>(at)];
      const int32_t next = links[0] == before ? links[1] : links[0];
      if (next == kNone) return piece;
      before = at;
      at = next;
      piece.push_back(at);
    }
  }

 private:
  void Link(int32_t node, int32_t to) {
    auto& links = links_[static_cast<size_t>(node)];
    links[links[0] == kNone ? 0 : 1] = to;
  }

  std::vector<std::array<int32_t, 2>> links_;
  DisjointSets pieces_;
};

struct Edge {
  int64_t length;
  NodePair ends;
};

std::vector<Edge> EdgesOf(const Costs& costs, const Neighbours& neighbours) {
  std::vector<Edge> edges;
  for (int32_t node = 0; node < costs.size(); ++node) {
    for (const Neighbour& near : neighbours.Of(node)) {
      if (!costs.IsNowhere(near.node)) edges.push_back({near.length, {node, near.node}});
    }
  }
  std::ranges::sort(edges, {}, [](const Edge& edge) {
    return std::tuple(edge.length, edge.ends.a, edge.ends.b);
  });
  return edges;
}

/// Returns the chains joined one after the other, each followed by the one with the nearest end.
/// The first chain is the one with the nowhere node (Costs::AddNowhere), if there is one.
Tour Chained(const Costs& costs, const Pieces& pieces) {
  std::vector<int32_t> ends;
  for (int32_t node = 0; node < costs.size(); ++node) {
    if (pieces.IsEnd(node)) ends.push_back(node);
  }
  Tour tour;
  tour.reserve(static_cast<size_t>(costs.size()));
  int32_t next = costs.IsNowhere(costs.size() - 1) ? costs.size() - 1 : ends.front();
  for (;;) {
    const Tour piece = pieces.From(next);
    tour.insert(tour.end(), piece.begin(), piece.end());
    std::erase_if(ends, [&](int32_t end) { return end == piece.front() || end == piece.back(); });
    if (ends.empty()) return tour;
    next =
        *std::ranges::min_element(ends, {}, [&](int32_t end) { return costs(piece.back(), end); });
  }
}

}  // namespace

Tour GreedyEdgeTour(const Costs& costs, const Neighbours& neighbours,
                    std::span<const NodePair> fixed) {
  Pieces pieces(costs.size());
  for (const NodePair& edge : fixed) pieces.Join(edge.a, edge.b);
  for (const Edge& edge : EdgesOf(costs, neighbours)) pieces.Join(edge.ends.a, edge.ends.b);
  return Chained(costs, pieces);
}

}  // namespace slicefarm::ordering
