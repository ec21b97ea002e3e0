#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "services/ordering/algo/tours/costs.h"
#include "services/ordering/algo/tours/tour_rules.h"

namespace slicefarm::ordering {

/// Returns the pairs of the nodes with the least sum of lengths. REQUIRES: an even number of
/// different nodes. Cost: LightestPerfectMatching on a few edges per node, and O(n^2) to prove that
/// no other edge improves the result.
std::vector<NodePair> MinimumMatching(const Costs& costs, std::span<const int32_t> nodes);

/// Returns a tour built from the shortest tree and a matching of its odd nodes. The closed trip
/// along both skips nodes that it has already visited. If lengths satisfy the triangle inequality,
/// the tour is at most 1.5 times as long as the shortest one. Source: N. Christofides, "Worst-Case
/// Analysis of a New Heuristic for the Travelling Salesman Problem", Carnegie-Mellon University
/// (1976).
Tour ChristofidesTour(const Costs& costs);

}  // namespace slicefarm::ordering
