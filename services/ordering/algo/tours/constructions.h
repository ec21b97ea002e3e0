#pragma once

#include <span>

#include "services/ordering/algo/tours/costs.h"
#include "services/ordering/algo/tours/neighbours.h"
#include "services/ordering/algo/tours/tour_rules.h"

namespace slicefarm::ordering {

/// Returns a tour of the fixed edges and of short edges between neighbours. Edges are added in
/// order of their length, unless an edge would make a branch or a ring. The resulting pieces are
/// joined end to end, the nearest piece next. All fixed edges are kept. A tie is decided by the
/// lower node. Cost: O(n log n), n nodes, and the square of the number of pieces.
Tour GreedyEdgeTour(const Costs& costs, const Neighbours& neighbours,
                    std::span<const NodePair> fixed);

}  // namespace slicefarm::ordering
