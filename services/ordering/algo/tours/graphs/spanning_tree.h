#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "services/ordering/algo/tours/costs.h"
#include "services/ordering/algo/tours/tour_rules.h"

namespace slicefarm::ordering {

struct SpanningTree {
  std::vector<NodePair> edges;
  int64_t length = 0;
};

/// The shortest tree that joins all nodes: no tour is shorter. Cost: O(n^2).
SpanningTree MinimumSpanningTree(const Costs& costs);

struct BoundOptions {
  int iterations = 100;
  int64_t upper_bound = 0;  ///< the length of some tour
};

/// A length that no tour with these fixed edges is below: the greatest of 1-trees under penalties
/// that pull each node's degree towards two. A 1-tree is a tree over all nodes but the first and
/// that one's two shortest edges; every tour is one. Penalties and sums are whole numbers, so that
/// the bound is sound to the last unit. Cost: O(n^2) an iteration. Source: M. Held, R. M. Karp,
/// "The Traveling-Salesman Problem and Minimum Spanning Trees: Part II", Mathematical Programming 1
/// (1971).
int64_t OneTreeBound(const Costs& costs, std::span<const NodePair> fixed,
                     const BoundOptions& options);

}  // namespace slicefarm::ordering
