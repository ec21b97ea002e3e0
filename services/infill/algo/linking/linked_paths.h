#pragma once

#include <limits>
#include <span>
#include <vector>

#include "common/model/path.h"
#include "services/infill/algo/lines/piece.h"
#include "services/infill/algo/linking/inner_ends.h"

namespace slicefarm::infill {

struct LinkOptions {
  Coord width_nm = 450'000;  ///< of beads
  double max_link_nm = 0;    ///< ends farther apart along the edge are not linked
  double anchor_nm = 0;      ///< how far a loose end turns along the edge
  /// What all links together may come to; beyond that the longest are left out.
  double budget_nm = std::numeric_limits<double>::infinity();
  /// Whether ends that lie beside the edge make room for links (LiftEnds), and links keep off lines
  /// there. Where lines fill the region up to its edge, they do not.
  bool lifts_ends = true;
  double min_length_nm = 0;  ///< shorter paths are left out
  InnerJoints inner = {};    ///< of ends inside the region; reach 0: none
  double facing_nm = 0;      ///< closed paths so far apart become one where they face each other
};

/// Joins pieces of any pattern to long paths of one width, by links along the region's edge. Ends
/// that stay loose turn along the edge, as far as nothing else is there (anchors). Ends inside the
/// region are joined to each other first.
///
/// Straight pieces are linked to rings (LinkAllEnds), and rings that cross taken into one another
/// (SplicedPaths): lines in several directions are one closed path then in most regions, which may
/// begin wherever the nozzle is. Where that gives more paths than open ones would be, and for
/// curves, paths are open (ChooseLinks), and end near each other (BringEndsTogether).
///
/// Lines that lie at even distances (`facing_nm`) are linked to rings too (LeastLinks), and rings
/// that face each other become one (LinkRings), which changes no length; open paths if those are
/// fewer.
///
/// Every piece is in exactly one path, and no stretch of the edge is used twice. Closed pieces stay
/// as they are. Cost: as ChooseLinks and SplicedPaths, and O(n + k) with n points of the region.
std::vector<Path> LinkedPaths(const MultiPolygon& region, std::span<const Piece> pieces,
                              const LinkOptions& options);

}  // namespace slicefarm::infill
