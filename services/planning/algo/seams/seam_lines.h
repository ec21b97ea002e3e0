#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/geometry/point.h"

namespace slicefarm::planning {

/// Chosen seam of a ring, and the range in which it may be moved.
struct SeamChoice {
  /// Index of the seam below in the same line of seams. It is smaller than the seam's own index;
  /// -1: none.
  int32_t parent = -1;
  Point at;
  /// Range within which the seam may move: along the line from `before` through `at` to `after`.
  /// For a fixed seam, for example at a corner, all three points are equal.
  Point before, after;

  bool IsFixed() const { return before == at && after == at; }
};

/// Straightens lines of seams, and returns the new point for each choice. Possible points are two
/// millimetres apart, so a leaning line of seams has steps of about this size. Each seam moves to
/// the mean of its neighbours in the line, up to eight below and eight above, within its range.
/// Fixed seams and the ends of lines do not move, and no mean includes seams beyond them. Where a
/// line splits, the first branch continues the line. Cost: O(choices).
std::vector<Point> SmoothSeams(std::span<const SeamChoice> choices);

}  // namespace slicefarm::planning
