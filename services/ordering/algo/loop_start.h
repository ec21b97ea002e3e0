#pragma once

#include <span>

#include "common/geometry/rings/loop_place.h"
#include "common/model/path.h"

namespace slicefarm::ordering {

/// The vertex nearest to `to`; of several, the least. REQUIRES: loop not empty.
LoopPlace NearestVertex(std::span<const Point> loop, Point to);

/// Where a loop with this seam starts: at a corner near to it, as corners hide seams best; else at
/// the nearest place, be it inside an edge: vertices of round walls turn from layer to layer, and
/// the seam would turn along. REQUIRES: loop not empty.
LoopPlace NearestToSeam(std::span<const Point> loop, Point seam);

/// The place so far along the loop, the way it is printed; round and round if the loop is shorter.
/// REQUIRES: a place of the loop; by_nm >= 0.
LoopPlace Further(std::span<const Point> loop, LoopPlace from, double by_nm);

/// Turns a closed path so that it starts (and ends) at `place`. A place inside an edge becomes a
/// point, of a width in between. Length, direction and beads stay.
void StartAt(LoopPlace place, Path& loop);

}  // namespace slicefarm::ordering
