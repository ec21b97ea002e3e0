#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "services/milling/algo/push/fiber_push.h"

namespace slicefarm::milling {

/// Fibers of one level: rows along x, one for each y; columns along y, one for each x.
struct Weave {
  const FiberGrid& x;
  const FiberGrid& y;
  const FiberIntervals& rows;
  const FiberIntervals& columns;
};

/// Crossing of a contour with a fiber: one end of an interval of this fiber.
struct Crossing {
  double x = 0;
  double y = 0;
  Source source;
  FiberAxis axis = FiberAxis::kX;  ///< axis of the fiber
  int32_t fiber = 0;               ///< index of the row or column
  bool high = false;               ///< true for the interval's high end
};

/// Closed contour with the gouged area on its left: outer contours run counter-clockwise, inner
/// ones clockwise.
using WovenLoop = std::vector<Crossing>;

/// Function that returns true if a tip position, in mm, is gouged.
using GougedAt = std::function<bool(double x, double y)>;

/// Returns the contours of the gouged area.
///
/// A node is the point where a row and a column of the grid cross. The rows alone decide which
/// nodes are gouged. Every end of an interval is a crossing, even if two of them are between the
/// same two nodes. In each cell, the crossings on its sides are linked in pairs. If there are four
/// or more, the pairs are chosen by testing whether the middle of the free parts is gouged. So
/// every crossing has one predecessor and one successor, and loops always close.
///
/// If the row and the column through a node disagree because of rounding, the crossing is put on
/// the node. Details completely between two fibers, or on only one fiber, are not detected.
/// REQUIRES: no node on the rim of the grid is gouged. Cost: O(n log n) for n crossings.
std::vector<WovenLoop> WeaveLoops(const Weave& weave, const GougedAt& gouged_at);

}  // namespace slicefarm::milling
