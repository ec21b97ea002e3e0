#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::slicing {

/// What became of the chains of a section, for the mesh report.
struct GapCounts {
  int64_t closed = 0;   ///< loops
  int64_t dropped = 0;  ///< lines that stayed open
  double largest_gap_nm = 0;
  double dropped_length_nm = 0;

  void Add(const GapCounts& other);
};

struct ClosedChains {
  std::vector<Polygon> loops;
  GapCounts counts;
};

/// Joins chains end to end into loops, over gaps of `max_gap_nm` at most.
///
/// Ends at the same place are joined first, then those within 4 nm, 16 nm, and so on up to the
/// largest gap: in each round those that keep the chains' direction, nearest first, then those that
/// turn one around. A line is closed onto itself only if the gap is below 0.3 of its length, so
/// that scraps do not become islands. In a loop of chains of both directions the longer part tells
/// which side the matter is on. What stays open is dropped and counted.
///
/// The result depends on the set of chains, not on their order. Cost: O(n log n) a round for n free
/// ends: after a round no two free ends that may be joined are nearer than its radius, so that the
/// next finds few candidates for each. Source: PrusaSlicer joins in such an order
/// (TriangleMeshSlicer), in one round.
ClosedChains CloseChains(std::vector<Polyline> chains, Coord max_gap_nm);

}  // namespace slicefarm::slicing
