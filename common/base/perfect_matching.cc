// LEMON 1.3.1 needs members of std::allocator that C++20 removed, so this file is C++17
// (CMakeLists.txt).
#include "common/base/perfect_matching.h"

#include <lemon/matching.h>
#include <lemon/smart_graph.h>

namespace slicefarm {
namespace {

using Graph = lemon::SmartGraph;
using Weights = Graph::EdgeMap<int64_t>;
using Solver = lemon::MaxWeightedPerfectMatching<Graph, Weights>;

}  // namespace

bool PerfectMatching::Proves(const WeightedEdge& edge) const {
  const auto& of_a = odd_sets[static_cast<size_t>(edge.a)];
  const auto& of_b = odd_sets[static_cast<size_t>(edge.b)];
  int64_t dual = node_dual[static_cast<size_t>(edge.a)] + node_dual[static_cast<size_t>(edge.b)] +
                 dual_scale * edge.weight;
  auto b = of_b.begin();
  for (auto a = of_a.begin(); dual < 0 && a != of_a.end(); ++a) {
    while (b != of_b.end() && b->number < a->number) ++b;
    if (b != of_b.end() && b->number == a->number) dual += a->dual;
  }
  return dual >= 0;
}

PerfectMatching LightestPerfectMatching(int32_t size, const std::vector<WeightedEdge>& edges) {
  Graph graph;
  graph.reserveNode(size);
  graph.reserveEdge(static_cast<int>(edges.size()));
  for (int32_t node = 0; node < size; ++node) graph.addNode();
  Weights heaviness(graph);
  for (const WeightedEdge& edge : edges) {
    const Graph::Edge added = graph.addEdge(Graph::nodeFromId(edge.a), Graph::nodeFromId(edge.b));
    heaviness[added] = -edge.weight;
  }
  Solver solver(graph, heaviness);
  solver.run();

  PerfectMatching matching;
  matching.dual_scale = Solver::dualScale;
  matching.odd_sets.resize(static_cast<size_t>(size));
  for (int32_t node = 0; node < size; ++node) {
    const Graph::Node at = Graph::nodeFromId(node);
    matching.mate.push_back(Graph::id(solver.mate(at)));
    matching.node_dual.push_back(solver.nodeValue(at));
  }
  for (int32_t set = 0; set < solver.blossomNum(); ++set) {
    const int64_t dual = solver.blossomValue(set);
    if (dual == 0) continue;
    for (Solver::BlossomIt at(solver, set); at != lemon::INVALID; ++at)
      matching.odd_sets[static_cast<size_t>(Graph::id(at))].push_back({set, dual});
  }
  return matching;
}

}  // namespace slicefarm
