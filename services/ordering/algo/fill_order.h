#pragma once

#include <optional>
#include <vector>

#include "services/ordering/algo/route.h"
#include "services/ordering/algo/travel_order.h"

namespace slicefarm::ordering {

/// Paths that are printed one after the other, in this order and direction.
struct FillBlock {
  std::vector<Path*> paths;  ///< at least one path
};

/// Prints the blocks to `route` in an order with little travel, ending near `next` if it is given.
/// The paths are moved from. Deterministic: the result does not depend on the order of `blocks`.
void PrintFills(std::vector<FillBlock> blocks, std::optional<Point> next, Route& route,
                WorkBudget& budget);

}  // namespace slicefarm::ordering
