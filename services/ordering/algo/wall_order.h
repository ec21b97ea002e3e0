#pragma once

#include <span>
#include <vector>

#include "common/model/ordering_options.h"
#include "services/ordering/algo/route.h"
#include "services/ordering/algo/travel_order.h"

namespace slicefarm::ordering {

struct WallRules {
  bool external_first = false;
  std::span<const Point> seams;  ///< start loops near these; empty: near the nozzle
};

/// Prints the walls of an island, contour by contour, each from the inside out (or from the outside
/// in). The paths are moved from. Deterministic; does not depend on the order of the walls.
void PrintWalls(std::span<Path* const> walls, const WallRules& rules, Route& route,
                WorkBudget& budget);

}  // namespace slicefarm::ordering
