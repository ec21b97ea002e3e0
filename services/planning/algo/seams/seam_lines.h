#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/geometry/point.h"

namespace slicefarm::planning {

/// Chosen seam of a ring, and the range in which it may be moved.
struct SeamChoice {
  /// index of the ring below in the same line of seams, always an earlier index; -1: none
  int32_t parent = -1;
  Point at;
  /// Ends of the seam's range. On a wall without corners the seam may move along the line from
  /// `before` through `at` to `after`. A fixed seam has both ends at `at`.
  Point before, after;

  bool IsFixed() const { return before == at && after == at; }
};

/// Straightens lines of seams along the walls. Possible points are two millimetres apart, so a
/// leaning line of seams has steps of about this size. Each seam moves to the mean of its
/// neighbours in the line, up to eight below and eight above. Fixed seams and the ends of lines
/// stay, and no mean includes seams beyond them. Where a line splits, the first branch continues
/// it. Shapes: one point per choice. Cost: O(choices).
std::vector<Point> SmoothSeams(std::span<const SeamChoice> choices);

}  // namespace slicefarm::planning
