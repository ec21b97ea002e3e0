#pragma once

#include <limits>
#include <span>
#include <vector>

#include "common/model/path.h"
#include "services/infill/algo/lines/piece.h"
#include "services/infill/algo/linking/inner_ends.h"

namespace slicefarm::infill {

/// Parameters of LinkedPaths.
struct LinkOptions {
  Coord width_nm = 450'000;  ///< width of beads
  double max_link_nm = 0;    ///< greatest distance along the edge of two ends that are linked
  double anchor_nm = 0;      ///< length by which a loose end turns along the edge
  /// Greatest total length of all links. If it is exceeded, the longest links are omitted.
  double budget_nm = std::numeric_limits<double>::infinity();
  /// True if ends beside the edge are moved to leave space for links (LiftEnds), and links keep off
  /// lines there. False for lines that fill the region up to its edge.
  bool lifts_ends = true;
  double min_length_nm = 0;  ///< least length of a path
  InnerJoints inner = {};    ///< joints of ends inside the region; reach 0: no joints
  double facing_nm = 0;  ///< distance at which closed paths that face each other are joined to one
};

/// Joins pieces of any pattern to long paths of one width, by links along the region's edge. Ends
/// that stay loose turn along the edge as far as it is free (anchors). Ends inside the region are
/// joined to each other first.
///
/// Straight pieces are linked to rings (LinkAllEnds), and crossing rings are inserted into each
/// other (SplicedPaths). Lines in several directions are then one closed path in most regions,
/// which may begin at the nozzle's position. If this gives more paths than open paths would, and
/// for curves, paths are open (ChooseLinks) and end near each other (BringEndsTogether).
///
/// Lines at even distances (`facing_nm`) are also linked to rings (LeastLinks). Rings that face
/// each other become one (LinkRings), which changes no length. If open paths are fewer, they are
/// used instead.
///
/// Every piece is in exactly one path, and no edge part is used twice. Closed pieces do not change.
/// Cost: as ChooseLinks and SplicedPaths, and O(n + k) with n points of the region.
std::vector<Path> LinkedPaths(const MultiPolygon& region, std::span<const Piece> pieces,
                              const LinkOptions& options);

}  // namespace slicefarm::infill
