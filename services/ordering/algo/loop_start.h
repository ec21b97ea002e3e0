#pragma once

#include <span>

#include "common/geometry/rings/loop_point.h"
#include "common/model/path.h"

namespace slicefarm::ordering {

/// Returns the vertex nearest to `to`; if several are equally near, the one with the lowest index.
/// REQUIRES: loop is not empty.
LoopPoint NearestVertex(std::span<const Point> loop, Point to);

/// Returns the point at which a loop with this seam starts: a corner near the seam, because corners
/// hide seams best. Without such a corner, returns the point of the loop nearest to the seam, which
/// may be inside an edge. A vertex that is no corner is not suitable: the vertices of round walls
/// move from layer to layer, and the start would move with them. REQUIRES: loop is not empty.
LoopPoint NearestToSeam(std::span<const Point> loop, Point seam);

/// Returns the point `by_nm` further along the loop in the direction of printing. The distance may
/// be longer than the loop. REQUIRES: `from` is on the loop; by_nm >= 0.
LoopPoint Further(std::span<const Point> loop, LoopPoint from, double by_nm);

/// Rotates the points of a closed path so that it starts and ends at `start`. If `start` is inside
/// an edge, it becomes a new point with an interpolated width. Length, direction and beads do not
/// change.
void StartAt(LoopPoint start, Path& loop);

}  // namespace slicefarm::ordering
