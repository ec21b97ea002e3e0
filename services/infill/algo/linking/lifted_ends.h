#pragma once

#include <span>
#include <vector>

#include "services/infill/algo/linking/taken_edge.h"

namespace slicefarm::infill {

struct LiftedPieces {
  std::vector<Piece> pieces;
  std::vector<std::vector<TakenSpan>> taken;  ///< of the edge, by ring
};

/// Pieces that come to the region's edge at a small angle, less what of them runs beside it: from
/// where they are as far from it as beads lie apart, they go straight to it. So what lies along the
/// edge afterwards, a link or an anchor, does not lie on them. As much of a piece as its end takes
/// is left out, 0.4 of it at most at each end; others stay, and take the edge.
/// Cost: as TakenEdge.
LiftedPieces LiftEnds(const MultiPolygon& region, std::span<const Piece> pieces, Coord width_nm);

}  // namespace slicefarm::infill
