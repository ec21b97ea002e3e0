#pragma once

#include <span>

#include "services/ordering/algo/tours/costs.h"
#include "services/ordering/algo/tours/neighbours.h"
#include "services/ordering/algo/tours/tour_rules.h"

namespace slicefarm::ordering {

/// Tours to begin with. All are deterministic; where nothing else decides, the lower node does.

/// From `first` always on to the nearest node that is left. Cost: O(n^2).
Tour NearestNeighbourTour(const Costs& costs, int32_t first);

/// The shortest edges between neighbours that make neither a branch nor a ring, after the fixed
/// ones; then the pieces one after the other, the nearest next. Keeps the fixed edges. Cost:
/// O(n log n) and the square of the number of pieces.
Tour GreedyEdgeTour(const Costs& costs, const Neighbours& neighbours,
                    std::span<const NodePair> fixed);

/// From node 0 on, the node that is farthest from the tour goes where it makes it least longer.
/// Cost: O(n^2).
Tour InsertionTour(const Costs& costs);

}  // namespace slicefarm::ordering
