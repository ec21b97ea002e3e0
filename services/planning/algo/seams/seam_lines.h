#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/geometry/point.h"

namespace slicefarm::planning {

/// The seam that was chosen for a ring, and how far to either side it may be moved.
struct SeamChoice {
  int32_t parent = -1;  ///< the ring below in whose line it stands, which comes before it; -1: none
  Point at;
  Point before, after;  ///< on a wall without corners it may lie anywhere on the way from `before`
                        ///< through `at` to `after`; a seam that has to stay has both at `at`

  bool IsFixed() const { return before == at && after == at; }
};

/// Seams in straight lines up the walls: places stand two millimetres apart, so a line of seams
/// that leans goes up in steps of about that much; here each seam moves to the mean of those around
/// it in its line, up to eight below and above. Fixed seams and the ends of lines stay, and no mean
/// reaches beyond them. Where lines part, the first goes on through the ring below.
/// Shapes: one a choice. Cost: O(choices).
std::vector<Point> SmoothSeams(std::span<const SeamChoice> choices);

}  // namespace slicefarm::planning
