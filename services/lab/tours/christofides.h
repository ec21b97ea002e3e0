#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "services/ordering/algo/tours/costs.h"
#include "services/ordering/algo/tours/tour_rules.h"

namespace slicefarm::lab {

/// Returns the perfect matching of the nodes (each node is in one pair) with the smallest total
/// length. REQUIRES: an even number of different nodes. Cost: LightestPerfectMatching on a few
/// edges per node, and O(n^2), n nodes, to prove that no other edge improves the result.
std::vector<ordering::NodePair> MinimumMatching(const ordering::Costs& costs,
                                                std::span<const int32_t> nodes);

/// Returns a tour built from the shortest spanning tree and a matching of its nodes of odd degree.
/// The tour follows the edges of both in a closed trip, but skips nodes that it has already
/// visited. If lengths satisfy the triangle inequality, the tour is at most 1.5 times as long as
/// the shortest one. Source: N. Christofides, "Worst-Case Analysis of a New Heuristic for the
/// Travelling Salesman Problem", Carnegie-Mellon University (1976).
ordering::Tour ChristofidesTour(const ordering::Costs& costs);

}  // namespace slicefarm::lab
