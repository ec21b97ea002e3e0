#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/milling/algo/push/fiber_frame.h"

namespace slicefarm::milling {

/// Evenly spaced coordinates of fibers.
struct FiberGrid {
  double first_mm = 0;
  double pitch_mm = 0;
  int32_t count = 0;

  /// Returns the coordinate of fiber i.
  double At(int32_t i) const { return first_mm + i * pitch_mm; }
};

/// Intervals in which the cutter gouges, per fiber of a grid; disjoint and ascending.
using FiberIntervals = std::vector<std::vector<Interval>>;

/// Pushes the cutter along all fibers of a frame, on many levels. Returns one FiberIntervals per
/// level.
///
/// Fibers are processed in blocks, and in each block the levels from the top down. An interval that
/// is gouged on one level is also gouged with a lower tip. So a level begins with the intervals of
/// the level above, minus a margin. A triangle with its box in a gouged interval is skipped. If
/// only the shaft can touch a triangle, its interval is the same on all lower levels. The triangle
/// is then settled: its interval is computed once. The ends always come from contacts on their own
/// level. So a level's result depends neither on the other levels nor on the number of threads.
/// Each edge is computed once per fiber.
///
/// REQUIRES: levels descend. Errors: Cancelled.
///
/// Cost: 3 ns per triangle and fiber within reach, on the levels where the triangle is not settled;
/// 0.1 us if the triangle is in no known gouged interval. Memory: 32 bytes per interval, 4 bytes
/// per triangle and block, 40 bytes per edge and thread.
absl::StatusOr<std::vector<FiberIntervals>> PushFibers(const FiberFrame& frame,
                                                       const Cutter& cutter, const FiberGrid& grid,
                                                       std::span<const double> levels_mm,
                                                       int threads, const CancelToken& cancel);

}  // namespace slicefarm::milling
