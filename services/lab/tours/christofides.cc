#include "services/lab/tours/christofides.h"

#include <algorithm>

#include "common/base/perfect_matching.h"
#include "services/lab/tours/spanning_tree.h"

namespace slicefarm::lab {
namespace {

using ordering::Costs;
using ordering::NodePair;
using ordering::Tour;

constexpr size_t kNearest = 8;

/// Returns enough edges for a perfect matching: each node's nearest nodes, and pairs of consecutive
/// nodes.
std::vector<WeightedEdge> FewEdges(const Costs& costs, std::span<const int32_t> nodes) {
  std::vector<WeightedEdge> few;
  std::vector<WeightedEdge> near;
  const auto size = static_cast<int32_t>(nodes.size());
  const auto edge = [&](int32_t a, int32_t b) {
    return WeightedEdge{a, b, costs(nodes[static_cast<size_t>(a)], nodes[static_cast<size_t>(b)])};
  };
  for (int32_t a = 0; a < size; ++a) {
    near.clear();
    for (int32_t b = 0; b < size; ++b) {
      if (a != b) near.push_back(edge(a, b));
    }
    const size_t count = std::min(kNearest, near.size());
    std::ranges::partial_sort(near, near.begin() + static_cast<ptrdiff_t>(count), {},
                              &WeightedEdge::weight);
    few.insert(few.end(), near.begin(), near.begin() + static_cast<ptrdiff_t>(count));
    if (a % 2 == 0) few.push_back(edge(a, a + 1));
  }
  return few;
}

/// Returns a closed trip that uses each link once. REQUIRES: all degrees are even, and the graph is
/// connected.
Tour RoundTrip(int32_t size, const std::vector<NodePair>& links) {
  std::vector<std::vector<size_t>> at(static_cast<size_t>(size));  // links by node
  for (size_t i = 0; i < links.size(); ++i) {
    at[static_cast<size_t>(links[i].a)].push_back(i);
    at[static_cast<size_t>(links[i].b)].push_back(i);
  }
  std::vector<uint8_t> used(links.size(), 0);
  Tour stack = {0};
  Tour trip;
  while (!stack.empty()) {
    const int32_t node = stack.back();
    auto& left = at[static_cast<size_t>(node)];
    while (!left.empty() && used[left.back()]) left.pop_back();
    if (left.empty()) {
      trip.push_back(node);
      stack.pop_back();
      continue;
    }
    const NodePair& link = links[left.back()];
    used[left.back()] = 1;
    stack.push_back(link.a == node ? link.b : link.a);
  }
  return trip;
}

}  // namespace

std::vector<NodePair> MinimumMatching(const Costs& costs, std::span<const int32_t> nodes) {
  if (nodes.empty()) return {};
  const auto size = static_cast<int32_t>(nodes.size());
  std::vector<WeightedEdge> edges = FewEdges(costs, nodes);
  for (;;) {
    const PerfectMatching matching = LightestPerfectMatching(size, edges);
    const size_t known = edges.size();
    for (int32_t a = 0; a < size; ++a) {
      for (int32_t b = a + 1; b < size; ++b) {
        const WeightedEdge edge{
            a, b, costs(nodes[static_cast<size_t>(a)], nodes[static_cast<size_t>(b)])};
        if (!matching.Proves(edge)) edges.push_back(edge);
      }
    }
    if (edges.size() > known) continue;
    std::vector<NodePair> pairs;
    for (int32_t a = 0; a < size; ++a) {
      const int32_t b = matching.mate[static_cast<size_t>(a)];
      if (a < b) pairs.push_back({nodes[static_cast<size_t>(a)], nodes[static_cast<size_t>(b)]});
    }
    return pairs;
  }
}

Tour ChristofidesTour(const Costs& costs) {
  std::vector<NodePair> links = MinimumSpanningTree(costs).edges;
  std::vector<int> degree(static_cast<size_t>(costs.size()), 0);
  for (const NodePair& link : links) {
    ++degree[static_cast<size_t>(link.a)];
    ++degree[static_cast<size_t>(link.b)];
  }
  std::vector<int32_t> odd;
  for (int32_t node = 0; node < costs.size(); ++node) {
    if (degree[static_cast<size_t>(node)] % 2 == 1) odd.push_back(node);
  }
  const std::vector<NodePair> matching = MinimumMatching(costs, odd);
  links.insert(links.end(), matching.begin(), matching.end());
  Tour tour;
  std::vector<uint8_t> seen(static_cast<size_t>(costs.size()), 0);
  for (const int32_t node : RoundTrip(costs.size(), links)) {
    if (seen[static_cast<size_t>(node)]) continue;
    seen[static_cast<size_t>(node)] = 1;
    tour.push_back(node);
  }
  return tour;
}

}  // namespace slicefarm::lab
