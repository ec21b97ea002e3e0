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
  /// Seams of contours, indexed by Path::ring of the contour's outermost wall. If this index is not
  /// in `seams`, the contour's loops start near the nozzle.
  std::span<const Point> seams;
  /// true: in a contour with a seam, each inner loop starts further along the loop than the seam,
  /// by the distance between the loop and the seam
  bool stagger = false;
};

/// Prints the walls of an island contour by contour, each in the order of the rules, ending near
/// `next` if it is given. The paths are moved from. Deterministic: the result does not depend on
/// the order of `walls`.
void PrintWalls(std::span<Path* const> walls, const WallRules& rules, std::optional<Point> next,
                Route& route, WorkBudget& budget);

}  // namespace slicefarm::ordering
