#include "services/ordering/algo/tours/tour_rules.h"

#include <algorithm>

namespace slicefarm::ordering {
namespace {

/// Returns the nodes of a chain of fixed edges that starts at `node` and leads away from `from`.
/// The result ends at the chain's end, or before `node` if the chain is a ring.
Tour ChainFrom(int32_t node, int32_t from, const FixedEdges& fixed) {
  Tour chain = {node};
  for (int32_t at = node;;) {
    const auto& mates = fixed.Of(at);
    const int32_t next = mates[0] == from ? mates[1] : mates[0];
    if (next == FixedEdges::kNone || next == node) return chain;
    from = at;
    at = next;
    chain.push_back(at);
  }
}

/// Returns the whole chain of fixed edges with this node. It begins with the end that is fewer
/// edges away.
Tour ChainOf(int32_t node, const FixedEdges& fixed) {
  const auto& [one, other] = fixed.Of(node);
  if (one == FixedEdges::kNone && other == FixedEdges::kNone) return {node};
  Tour there = ChainFrom(node, other, fixed);
  if (other == FixedEdges::kNone) return there;
  Tour back = ChainFrom(node, one, fixed);
  if (there.size() > 1 && there.size() == back.size() && there[1] == back.back())
    return there;  // a ring
  if (there.size() < back.size()) std::swap(there, back);
  std::reverse(back.begin(), back.end());
  back.insert(back.end(), there.begin() + 1, there.end());
  return back;
}

}  // namespace

FixedEdges::FixedEdges(int32_t size, std::span<const NodePair> edges)
    : mates_(static_cast<size_t>(size), {kNone, kNone}) {
  const auto join = [this](int32_t node, int32_t mate) {
    auto& mates = mates_[static_cast<size_t>(node)];
    mates[mates[0] == kNone ? 0 : 1] = mate;
  };
  for (const NodePair& edge : edges) {
    join(edge.a, edge.b);
    join(edge.b, edge.a);
  }
}

Tour WithFixedEdges(const Tour& tour, const FixedEdges& fixed) {
  Tour kept;
  kept.reserve(tour.size());
  std::vector<uint8_t> seen(tour.size(), 0);
  for (const int32_t node : tour) {
    if (seen[static_cast<size_t>(node)]) continue;
    for (const int32_t link : ChainOf(node, fixed)) {
      seen[static_cast<size_t>(link)] = 1;
      kept.push_back(link);
    }
  }
  return kept;
}

bool Keeps(const Tour& tour, int32_t size, const TourRules& rules) {
  if (tour.size() != static_cast<size_t>(size)) return false;
  std::vector<int32_t> rank(tour.size(), -1);
  for (size_t i = 0; i < tour.size(); ++i) {
    const int32_t node = tour[i];
    if (node < 0 || node >= size || rank[static_cast<size_t>(node)] >= 0) return false;
    rank[static_cast<size_t>(node)] = static_cast<int32_t>(i);
  }
  const auto ahead = [&](int32_t from, int32_t node) {  // number of steps forward
    const int32_t steps = rank[static_cast<size_t>(node)] - rank[static_cast<size_t>(from)];
    return steps < 0 ? steps + size : steps;
  };
  for (const NodePair& edge : rules.fixed) {
    const int32_t steps = ahead(edge.a, edge.b);
    if (steps != 1 && steps != size - 1) return false;
  }
  const bool backward = ahead(rules.first, rules.last) == 1 && size > 2;
  const auto order = [&](int32_t node) {
    const int32_t steps = ahead(rules.first, node);
    return backward ? (size - steps) % size : steps;
  };
  return std::ranges::all_of(rules.before,
                             [&](const NodePair& pair) { return order(pair.a) < order(pair.b); });
}

}  // namespace slicefarm::ordering
