#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/milling/algo/push/fiber_frame.h"

namespace slicefarm::milling {

/// Evenly spaced places.
struct FiberGrid {
  double first_mm = 0;
  double pitch_mm = 0;
  int32_t count = 0;

  double At(int32_t i) const { return first_mm + i * pitch_mm; }
};

/// By fiber of a grid: where on it the cutter gouges, disjoint and ascending.
using FiberIntervals = std::vector<std::vector<Interval>>;

/// Pushes the cutter along all fibers of a frame, on many levels. The result is by level.
///
/// Fibers are taken in blocks, and in each block the levels from the top down: what a cutter gouges
/// it also gouges with its tip lower. So a level begins with the intervals of the level above it,
/// less a margin; a triangle whose box lies in what is known to be gouged is skipped; a triangle
/// that lies beside the shaft alone is settled: it is pushed against once, and its interval kept
/// for all levels below. Ends are always those of contacts on their own level, so a level's result
/// depends neither on the other levels nor on the number of threads. A fiber computes each edge
/// once.
///
/// REQUIRES: levels descend. Errors: Cancelled.
/// Cost: 3 ns for a triangle and a fiber that the cutter may reach from it, and 0.1 us where that
/// is not known to be gouged, on the levels where the triangle is not settled. Memory: 32 bytes an
/// interval, 4 bytes a triangle and block, 40 bytes an edge and thread.
absl::StatusOr<std::vector<FiberIntervals>> PushFibers(const FiberFrame& frame,
                                                       const Cutter& cutter, const FiberGrid& grid,
                                                       std::span<const double> levels_mm,
                                                       int threads, const CancelToken& cancel);

}  // namespace slicefarm::milling
