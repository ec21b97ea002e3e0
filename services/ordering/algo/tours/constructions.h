#pragma once

#include <span>

#include "services/ordering/algo/tours/costs.h"
#include "services/ordering/algo/tours/neighbours.h"
#include "services/ordering/algo/tours/tour_rules.h"

namespace slicefarm::ordering {

/// Initial tours. All functions are deterministic: a tie is decided by the lower node. In costs, n
/// is the number of nodes.

/// Returns the tour that begins at `first` and always continues to the nearest unvisited node.
/// Cost: O(n^2).
Tour NearestNeighbourTour(const Costs& costs, int32_t first);

/// Returns a tour of the fixed edges and of short edges between neighbours. Edges are added in
/// order of their length, unless an edge would make a branch or a ring. The resulting pieces are
/// joined end to end, the nearest piece next. All fixed edges are kept. Cost: O(n log n) and the
/// square of the number of pieces.
Tour GreedyEdgeTour(const Costs& costs, const Neighbours& neighbours,
                    std::span<const NodePair> fixed);

/// Returns a tour that grows from node 0: the node farthest from the tour is inserted at the
/// position that lengthens the tour least. Cost: O(n^2).
Tour InsertionTour(const Costs& costs);

}  // namespace slicefarm::ordering
