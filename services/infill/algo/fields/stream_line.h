#pragma once

#include <deque>

#include "common/geometry/vector.h"

namespace slicefarm::infill {

/// A line along a field of directions. A closed one goes on from its last point to its first.
struct StreamLine {
  std::deque<Vector2> points;  ///< it grows at both ends
  bool closed = false;
};

}  // namespace slicefarm::infill
