#pragma once

#include <functional>
#include <vector>

#include "common/geometry/vector.h"

namespace slicefarm::infill {

/// One zero line of a function that repeats in u and v with period 1. A closed one repeats at each
/// step of (1, 0) and (0, 1); an open one goes on from its last point, which is its first one
/// `step_u`, `step_v` farther, for ever. Positive values lie to the left.
struct LevelLine {
  std::vector<Vector2> points;  ///< open: with the last one; closed: the first is not repeated
  int step_u = 0;
  int step_v = 0;

  bool IsClosed() const { return step_u == 0 && step_v == 0; }
};

/// The zero lines of a function that repeats with period 1, by marching squares on a grid of
/// `count` squares a period. Points lie on the lines where these cross the grid. In a square with
/// four crossings the sign in its middle decides. Zero counts as positive.
///
/// REQUIRES: count >= 2. Cost: O(count^2) calls, and some 8 for each point.
std::vector<LevelLine> LevelLines(const std::function<double(Vector2)>& function, int count);

}  // namespace slicefarm::infill
