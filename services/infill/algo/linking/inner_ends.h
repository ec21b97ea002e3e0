#pragma once

#include <span>
#include <vector>

#include "services/infill/algo/lines/piece.h"

namespace slicefarm::infill {

struct InnerJoints {
  double reach_nm = 0;  ///< ends farther apart are not joined
  double most_added =
      0;  ///< what a joint may add to the length of all lines, of its ends' distance
  double width_nm = 450'000;  ///< of beads
};

/// Joins ends of pieces that lie inside the region, where no wall can bear a link. Two ends are cut
/// back by half as much each as the straight line between them is long then, so that the length of
/// all lines stays. Where they face each other, none of that length may be; then the joint adds a
/// little. As many ends as can be found are joined, the nearest first. A piece gives up less than
/// half of its length at each end; joints cross no edge of the region, and lie on no other line.
/// Pieces that are joined to a ring are closed. Ends for which there is no joint stay.
/// Cost: O(n log n + k m) for n ends with k others within reach, m points of a piece.
std::vector<Piece> JoinInnerEnds(const MultiPolygon& region, std::span<const Piece> pieces,
                                 const InnerJoints& joints);

}  // namespace slicefarm::infill
