#pragma once

#include <optional>
#include <vector>

#include "services/ordering/algo/route.h"
#include "services/ordering/algo/travel_order.h"

namespace slicefarm::ordering {

/// A path, or several that are printed in this order and direction.
struct FillBlock {
  std::vector<Path*> paths;  ///< not empty
};

/// Prints the blocks in an order of little travel, towards `next` if there is such a place. The
/// paths are moved from. Deterministic; does not depend on the order of the blocks.
void PrintFills(std::vector<FillBlock> blocks, std::optional<Point> next, Route& route,
                WorkBudget& budget);

}  // namespace slicefarm::ordering
