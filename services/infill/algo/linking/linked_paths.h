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
  double max_link_nm = 0;    ///< largest length of a link along the region's boundary
  /// length in nm for which a path continues along the boundary at a loose end
  double anchor_nm = 0;
  /// Largest total length of all links, in nm. If the links are longer, the longest ones are
  /// omitted.
  double budget_nm = std::numeric_limits<double>::infinity();
  /// True if pieces beside the boundary are lifted from it to leave space for links (LiftEnds), and
  /// if links avoid other lines there. False for lines that fill the region up to its boundary.
  bool lifts_ends = true;
  double min_length_nm = 0;  ///< shorter paths are omitted
  InnerJoints inner = {};    ///< joints of ends inside the region; reach 0: no joints
  /// Distance between neighbouring rings that are joined into one path; 0: they stay separate.
  double facing_nm = 0;
};

/// Joins pieces of any pattern into long paths of one width, by links along the region's boundary.
/// An anchor is the part of a path that continues along the boundary at a loose end, as far as the
/// boundary is free. Ends inside the region are joined to each other first.
///
/// Straight pieces are linked to rings (LinkAllEnds), and crossing rings are inserted into each
/// other (SplicedPaths). Lines in several directions then form one closed path in most regions.
/// This path may begin at the nozzle's position. Curves are linked to open paths (ChooseLinks), and
/// so are straight pieces if this gives fewer paths. The ends of open paths are moved near each
/// other (BringEndsTogether).
///
/// Lines at even distances (`facing_nm` > 0) are also linked to rings (LeastLinks). Rings that face
/// each other are joined into one (LinkRings), which changes no length. Open paths are used instead
/// if there are fewer of them.
///
/// Every piece is in exactly one path, and no edge part is used twice. Closed pieces do not change.
/// Cost: the cost of ChooseLinks and SplicedPaths, and O(n + k), n points of the region, k pieces.
std::vector<Path> LinkedPaths(const MultiPolygon& region, std::span<const Piece> pieces,
                              const LinkOptions& options);

}  // namespace slicefarm::infill
