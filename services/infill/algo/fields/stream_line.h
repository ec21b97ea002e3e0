#pragma once

#include <deque>

#include "common/geometry/vector.h"

namespace slicefarm::infill {

/// Line along a field of directions, in mm. If closed, it continues from its last point to its
/// first.
struct StreamLine {
  std::deque<Vector2> points;  ///< the line grows at both ends
  bool closed = false;
};

}  // namespace slicefarm::infill
