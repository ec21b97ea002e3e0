#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "services/ordering/algo/tours/costs.h"
#include "services/ordering/algo/tours/tour_rules.h"

namespace slicefarm::ordering {

/// Pairs of the nodes with the least sum of lengths. REQUIRES: an even number of different nodes.
/// Cost: that of LightestPerfectMatching on a few edges a node, and O(n^2) to see that the others
/// do not matter.
std::vector<NodePair> MinimumMatching(const Costs& costs, std::span<const int32_t> nodes);

/// The shortest tree, a matching of its odd nodes, and the round trip along both that leaves out
/// what it has already visited: if lengths keep the triangle inequality, at most 1.5 times as long
/// as the shortest tour. Source: N. Christofides, "Worst-Case Analysis of a New Heuristic for the
/// Travelling Salesman Problem", Carnegie-Mellon University (1976).
Tour ChristofidesTour(const Costs& costs);

}  // namespace slicefarm::ordering
