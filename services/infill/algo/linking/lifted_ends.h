#pragma once

#include <span>
#include <vector>

#include "services/infill/algo/linking/taken_edge.h"

namespace slicefarm::infill {

/// Pieces after LiftEnds, and the parts of the edge that are not free.
struct LiftedPieces {
  std::vector<Piece> pieces;
  std::vector<std::vector<TakenSpan>> taken;  ///< parts of the edge that are not free, per ring
};

/// Lifts pieces that meet the region's edge at a small angle: the part of a piece beside the edge
/// is removed. From the point where the piece is a bead's distance from the edge, it runs straight
/// to the edge. A later link or anchor along the edge therefore does not overlap the piece. At each
/// end at most 0.4 of a piece is removed; other pieces do not change, and occupy the edge. Cost: as
/// TakenEdge.
LiftedPieces LiftEnds(const MultiPolygon& region, std::span<const Piece> pieces, Coord width_nm);

}  // namespace slicefarm::infill
