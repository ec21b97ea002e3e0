#pragma once

#include <span>
#include <vector>

#include "common/model/path.h"
#include "services/infill/algo/lines/piece.h"

namespace slicefarm::infill {

struct LinkOptions {
  Coord width_nm = 450'000;  ///< of beads
  Coord height_nm = 200'000;
  double max_link_nm = 0;  ///< ends farther apart along the edge are not linked
  double anchor_nm = 0;    ///< how far a loose end turns along the edge
  double most_cut_nm = 0;  ///< how much of a corner may be cut off
  /// What all links and anchors together may add to the pieces' length, in beads of full width.
  double budget_nm = 0;
  /// What they are to add: they are made thinner for it, but not left out. REQUIRES: no more than
  /// the budget.
  double aim_nm = budget_nm;
  double most_flow = 1;    ///< of a link, as a share of a bead's: what the edge leaves room for
  double least_flow = 1;   ///< links that would be thinner are not made
  double min_length_nm = 0;  ///< shorter paths are left out
};

/// Joins pieces of any pattern to long paths, by links along the region's edge. First these are as
/// wide as there is room beside the wall; where they cost more plastic than `aim_nm`, their corners
/// are cut off, and then they become thinner; and only where that is more than `budget_nm` yet, the
/// longest ones are left out.
///
/// Straight pieces are linked to rings (LinkAllEnds), and rings that cross taken into one another
/// (SplicedPaths): lines in several directions are one closed path then in most regions, which may
/// begin wherever the nozzle is. Where that gives more paths than open ones would be, and for
/// curves, paths are open (ChooseLinks), and end near each other (BringEndsTogether).
///
/// Every piece is in exactly one path, and no stretch of the edge is used twice. Closed pieces stay
/// as they are. Cost: as ChooseLinks and SplicedPaths, and O(n + k) with n points of the region.
std::vector<Path> LinkedPaths(const MultiPolygon& region, std::span<const Piece> pieces,
                              const LinkOptions& options);

}  // namespace slicefarm::infill
