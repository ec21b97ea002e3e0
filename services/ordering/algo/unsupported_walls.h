#pragma once

#include <vector>

#include "common/geometry/polygon.h"
#include "common/model/path.h"

namespace slicefarm::ordering {

/// Removes from `walls` the contours that are over air alone, and returns them: all of a contour's
/// walls are closed, and their centre lines are in `air`. A contour with a wall that rests on
/// something can be printed from that wall outwards, so it remains. Cost: boolean operations for
/// the walls with all points in `air`.
std::vector<Path*> TakeUnsupported(std::vector<Path*>& walls, const MultiPolygon& air);

}  // namespace slicefarm::ordering
