#pragma once

#include <span>
#include <vector>

#include "services/infill/algo/linking/taken_edge.h"

namespace slicefarm::infill {

/// Pieces after LiftEnds, and the parts of the boundary that are not free.
struct LiftedPieces {
  std::vector<Piece> pieces;
  /// Parts of the boundary that are not free, one list per ring.
  std::vector<std::vector<TakenSpan>> taken;
};

/// Lifts pieces that meet the region's boundary at a small angle: the part of a piece beside the
/// boundary is removed. From the point where the piece is a bead's distance from the boundary, the
/// piece now leads straight to the boundary. A later link or anchor along the boundary therefore
/// does not overlap the piece. At each end at most 0.4 of a piece is removed. All other pieces do
/// not change, and the boundary beside them is not free. Cost: the cost of TakenEdge.
LiftedPieces LiftEnds(const MultiPolygon& region, std::span<const Piece> pieces, Coord width_nm);

}  // namespace slicefarm::infill
