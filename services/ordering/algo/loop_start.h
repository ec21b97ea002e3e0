#pragma once

#include <span>

#include "common/model/path.h"

namespace slicefarm::ordering {

/// A place on a loop: on the edge from point `edge` to the next; `at` is that point itself if it
/// lies there.
struct LoopPlace {
  size_t edge = 0;
  Point at;

  friend bool operator==(const LoopPlace&, const LoopPlace&) = default;
};

/// The vertex nearest to `to`; of several, the least. REQUIRES: loop not empty.
LoopPlace NearestVertex(std::span<const Point> loop, Point to);

/// Where a loop with this seam starts: at the vertex nearest to it, as corners hide seams best; but
/// inside an edge if the vertices are so far away that the seam would wander from layer to layer.
/// REQUIRES: loop not empty.
LoopPlace NearestToSeam(std::span<const Point> loop, Point seam);

/// Turns a closed path so that it starts (and ends) at `place`. A place inside an edge becomes a
/// point, of a width in between. Length, direction and beads stay.
void StartAt(LoopPlace place, Path& loop);

}  // namespace slicefarm::ordering
