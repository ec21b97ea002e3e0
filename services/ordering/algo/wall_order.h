#pragma once

#include <optional>
#include <span>
#include <vector>

#include "services/ordering/algo/route.h"
#include "services/ordering/algo/travel_order.h"

namespace slicefarm::ordering {

enum class InsetOrder {
  kInnerFirst,
  kOuterFirst,
  kInnerOuterInner,  ///< all from the innermost to the third, then the outermost, then the second
  /// The island's outer contour from outside, then its holes' from inside: the outermost line of a
  /// brim comes first, those that touch the part come last.
  kTowardsHoles,
};

struct WallRules {
  InsetOrder order = InsetOrder::kInnerFirst;
  /// Where the loops of a contour start, by the ring that its outermost wall follows; a contour
  /// along no ring, or all if this is empty, start near the nozzle.
  std::span<const Point> seams;
  /// Inner loops of a contour with a seam start further along, each by as much as it lies inside of
  /// the seam.
  bool stagger = false;
};

/// Prints the walls of an island, contour by contour, each in the order of the rules, towards
/// `next` if there is such a place. The paths are moved from. Deterministic; does not depend on the
/// order of the walls.
void PrintWalls(std::span<Path* const> walls, const WallRules& rules, std::optional<Point> next,
                Route& route, WorkBudget& budget);

}  // namespace slicefarm::ordering
