#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "services/ordering/algo/tours/costs.h"
#include "services/ordering/algo/tours/tour_rules.h"

namespace slicefarm::lab {

/// Edges of a tree over all nodes, and their total length.
struct SpanningTree {
  std::vector<ordering::NodePair> edges;
  int64_t length = 0;
};

/// Returns the shortest tree that joins all nodes. No tour is shorter than this tree. Cost: O(n^2),
/// n nodes.
SpanningTree MinimumSpanningTree(const ordering::Costs& costs);

/// Limits of the search for a lower bound.
struct BoundOptions {
  int iterations = 100;
  int64_t upper_bound = 0;  ///< length of any known tour
};

/// Returns a lower bound of the length of tours with these fixed edges: the greatest length of
/// 1-trees, under penalties that change each node's degree towards two. A 1-tree is a tree over all
/// nodes except the first, plus the two shortest edges of the first node. Every tour is a 1-tree.
/// Penalties and sums are whole numbers, so that the bound is exact to the last unit. Cost: O(n^2)
/// per iteration, n nodes. Source: M. Held, R. M. Karp, "The Traveling-Salesman Problem and Minimum
/// Spanning Trees: Part II", Mathematical Programming 1 (1971).
int64_t OneTreeBound(const ordering::Costs& costs, std::span<const ordering::NodePair> fixed,
                     const BoundOptions& options);

}  // namespace slicefarm::lab
