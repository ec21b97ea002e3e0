#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::slicing {

/// Numbers of closed and dropped chains of a section, and the largest closed gap, for the mesh
/// report.
struct GapCounts {
  int64_t closed = 0;   ///< number of chains that became part of a loop
  int64_t dropped = 0;  ///< number of chains that could not be closed
  double largest_gap_nm = 0;
  double dropped_length_nm = 0;

  /// Adds the numbers of `other`; keeps the larger of the two gaps.
  void Add(const GapCounts& other);
};

/// Loops made of chains, with their counts.
struct ClosedChains {
  std::vector<Polygon> loops;
  GapCounts counts;
};

/// Joins chains (open lines of a section) end to end into loops, over gaps of at most `max_gap_nm`.
///
/// Ends at the same point are joined first, then ends within 4 nm, within 16 nm, and so on up to
/// the largest gap. Each round first joins ends that keep the chains' direction, nearest first.
/// Then it joins ends that reverse one chain. A line is closed onto itself only if the gap is below
/// 0.3 of its length, so that scraps do not become islands. If a loop contains chains of both
/// directions, the longer part decides on which side the material is. Chains that stay open are
/// dropped and counted.
///
/// The result depends on the set of chains, not on their order. Cost: O(n log n) per round for n
/// free ends. After a round, free ends that may be joined are farther apart than its radius, so the
/// next round finds few candidates for each. Source: PrusaSlicer joins in such an order
/// (TriangleMeshSlicer), in one round.
ClosedChains CloseChains(std::vector<Polyline> chains, Coord max_gap_nm);

}  // namespace slicefarm::slicing
