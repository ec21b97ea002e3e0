#pragma once

#include <cstdint>

#include "services/ordering/algo/tours/costs.h"
#include "services/ordering/algo/tours/tour_rules.h"

namespace slicefarm::lab {

/// Returns the tour that begins at `first` and always continues to the nearest unvisited node. A
/// tie is decided by the lower node. Cost: O(n^2), n nodes.
ordering::Tour NearestNeighbourTour(const ordering::Costs& costs, int32_t first);

/// Returns a tour that grows from node 0: the node farthest from the tour is inserted at the
/// position that lengthens the tour least. A tie is decided by the lower node. Cost: O(n^2), n
/// nodes.
ordering::Tour InsertionTour(const ordering::Costs& costs);

}  // namespace slicefarm::lab
