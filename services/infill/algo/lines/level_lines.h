#pragma once

#include <functional>
#include <vector>

#include "common/geometry/vector.h"

namespace slicefarm::infill {

/// Zero line of a function that repeats in u and v with period 1. A closed line repeats at each
/// step of (1, 0) and (0, 1). An open line continues without end: its last point is its first point
/// shifted by `step_u`, `step_v`. The function is positive to the left of the line.
struct LevelLine {
  /// Points of one period. An open line includes its last point; a closed line does not repeat its
  /// first point.
  std::vector<Vector2> points;
  int step_u = 0;
  int step_v = 0;

  bool IsClosed() const { return step_u == 0 && step_v == 0; }
};

/// Returns the zero lines of a function that repeats with period 1, by marching squares on a grid
/// of `count` x `count` squares per period. Points are the crossings of the lines and the grid. In
/// a square with four crossings, the sign in the square's middle decides which crossings are
/// connected. Zero counts as positive.
///
/// REQUIRES: count >= 2. Cost: O(count^2) calls of the function, and about 8 further calls for each
/// point.
std::vector<LevelLine> LevelLines(const std::function<double(Vector2)>& function, int count);

}  // namespace slicefarm::infill
