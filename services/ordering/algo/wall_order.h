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
  kInnerOuterInner,  ///< first the innermost to the third, then the outermost, then the second
  /// The island's outer contour from outside inwards, then the contours of its holes from inside
  /// the material towards the hole. So the outermost line of a brim is printed first, and the lines
  /// that touch the part are printed last.
  kTowardsHoles,
};

/// Rules for printing the walls of an island.
struct WallRules {
  InsetOrder order = InsetOrder::kInnerFirst;
  /// Starts of a contour's loops, indexed by the ring that its outermost wall follows. The loops of
  /// a contour without a ring start near the nozzle, and so do all loops if this is empty.
  std::span<const Point> seams;
  /// True to start each inner loop of a contour with a seam further along, by the distance between
  /// the loop and the seam.
  bool stagger = false;
};

/// Prints the walls of an island contour by contour, each in the order of the rules, ending near
/// `next` if it is given. The paths are moved from. Deterministic: the result does not depend on
/// the order of `walls`.
void PrintWalls(std::span<Path* const> walls, const WallRules& rules, std::optional<Point> next,
                Route& route, WorkBudget& budget);

}  // namespace slicefarm::ordering
