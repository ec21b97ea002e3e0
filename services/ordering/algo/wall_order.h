#pragma once

#include <optional>
#include <span>
#include <vector>

#include "services/ordering/algo/route.h"
#include "services/ordering/algo/travel_order.h"

namespace slicefarm::ordering {

/// Order of the walls of a contour.
enum class InsetOrder {
  kInnerFirst,
  kOuterFirst,
  /// First the walls from the innermost to the third from outside, then the outermost, then the
  /// second.
  kInnerOuterInner,
  /// The island's outer contour from outside inwards, then the contours of its holes from inside
  /// the material towards the hole. So the outermost line of a brim is printed first, and the lines
  /// that touch the part are printed last.
  kTowardsHoles,
};

/// Rules for printing the walls of an island.
struct WallRules {
  InsetOrder order = InsetOrder::kInnerFirst;
  /// Seams of contours, indexed by the ring that the contour's outermost wall follows. The loops of
  /// a contour without a ring in `seams` start near the nozzle.
  std::span<const Point> seams;
  /// True to start each inner loop of a contour with a seam not at the seam but further along the
  /// loop, by the distance between loop and seam.
  bool stagger = false;
};

/// Prints the walls of an island contour by contour, each in the order of the rules, ending near
/// `next` if it is given. The paths are moved from. Deterministic: the result does not depend on
/// the order of `walls`.
void PrintWalls(std::span<Path* const> walls, const WallRules& rules, std::optional<Point> next,
                Route& route, WorkBudget& budget);

}  // namespace slicefarm::ordering
