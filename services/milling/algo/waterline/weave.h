#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "services/milling/algo/push/fiber_push.h"

namespace slicefarm::milling {

/// The fibers of one level, woven: rows along x, one for each y; columns along y, one for each x.
struct Weave {
  const FiberGrid& x;
  const FiberGrid& y;
  const FiberIntervals& rows;
  const FiberIntervals& columns;
};

/// Where a contour crosses a fiber: the end of an interval.
struct Crossing {
  double x = 0;
  double y = 0;
  Source source;
  FiberAxis axis = FiberAxis::kX;  ///< of the fiber
  int32_t fiber = 0;               ///< row or column
  bool high = false;               ///< the interval's high end
};

/// A closed contour, what is gouged on its left: outer ones run counter-clockwise, inner ones
/// clockwise.
using WovenLoop = std::vector<Crossing>;

/// Tells whether a place is gouged.
using GougedAt = std::function<bool(double x, double y)>;

/// The contours of what is gouged.
///
/// Rows alone tell which nodes of the grid are gouged; every end of an interval is a crossing, also
/// where two of them lie between the same two nodes. Each cell links the crossings around it in
/// pairs; where it has four or more, the middle of its free stretches tells which belong together.
/// So every crossing has one before it and one after it, and loops always close. Where rows and
/// columns differ about a node, by rounding, the crossing is put on the node. What lies between two
/// fibers as a whole is not seen, nor what only one fiber sees. REQUIRES: no node on the rim of the
/// grid is gouged. Cost: O(n log n) for n crossings.
std::vector<WovenLoop> WeaveLoops(const Weave& weave, const GougedAt& gouged_at);

}  // namespace slicefarm::milling
