#pragma once

#include <span>
#include <vector>

#include "services/infill/algo/lines/piece.h"

namespace slicefarm::infill {

/// Limits for joints of ends inside a region.
struct InnerJoints {
  double reach_nm = 0;  ///< largest distance between two ends that are joined
  /// Largest length that a joint may add to the lines, as a share of the distance between its two
  /// ends.
  double most_added = 0;
  double width_nm = 450'000;  ///< width of beads
};

/// Joins ends of pieces inside the region, where no wall can support a link. A joint is a straight
/// line. Both ends are cut back by half of the joint's length, so that the total length of the
/// lines stays the same. For ends that face each other, no cut is long enough for this. Then the
/// joint adds a little length (`most_added`).
///
/// The search joins as many ends as it can, the nearest first. A piece loses less than half of its
/// length at each end. A joint crosses no edge of the region and does not overlap another line.
/// Pieces that are joined into a ring become closed. Ends without a joint do not change. Cost: O(n
/// log n + k m) for n ends with k other ends within reach, m points of a piece.
std::vector<Piece> JoinInnerEnds(const MultiPolygon& region, std::span<const Piece> pieces,
                                 const InnerJoints& joints);

}  // namespace slicefarm::infill
