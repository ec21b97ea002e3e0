#pragma once

#include <span>
#include <vector>

#include "services/infill/algo/linking/taken_edge.h"

namespace slicefarm::infill {

/// Result of LiftEnds.
struct LiftedPieces {
  std::vector<Piece> pieces;
  /// Parts of the boundary that are not free for beads, one list per ring.
  std::vector<std::vector<TakenSpan>> taken;
};

/// Lifts the ends of pieces that meet the region's boundary at a small angle. The part of a piece
/// that is too near to the boundary for a second bead is removed. From there, the shortened piece
/// leads straight to the boundary. A later link or anchor along the boundary therefore does not
/// overlap the piece. An end is not lifted if more than 0.4 of the piece would be removed. Such
/// pieces do not change, and the boundary beside them is not free. Cost: the cost of TakenEdge.
LiftedPieces LiftEnds(const MultiPolygon& region, std::span<const Piece> pieces, Coord width_nm);

}  // namespace slicefarm::infill
