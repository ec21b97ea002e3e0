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
  double anchor_nm = 0;  ///< length for which a path continues along the boundary at a loose end
  /// Largest total length of all links. If this is exceeded, the longest links are omitted.
  double budget_nm = std::numeric_limits<double>::infinity();
  /// True if pieces beside the boundary are moved away to leave space for links (LiftEnds), and if
  /// links avoid other lines there. False for lines that fill the region up to its boundary.
  bool lifts_ends = true;
  double min_length_nm = 0;  ///< smallest length of a path
  InnerJoints inner = {};    ///< joints of ends inside the region; reach 0: no joints
  /// Distance between neighbouring rings that are joined into one path; 0: they stay separate.
  double facing_nm = 0;
};

/// Joins pieces of any pattern into long paths of one width, by links along the region's boundary.
/// At an end that stays loose, the path continues along the boundary as far as it is free (anchor).
/// Ends inside the region are joined to each other first.
///
/// Straight pieces are linked to rings (LinkAllEnds), and crossing rings are inserted into each
/// other (SplicedPaths). Lines in several directions are then one closed path in most regions,
/// which may begin at the nozzle's position. Open paths (ChooseLinks) are used for curves, and if
/// they are fewer. Their ends are moved near each other (BringEndsTogether).
///
/// Lines at even distances (`facing_nm` > 0) are also linked to rings (LeastLinks). Rings that face
/// each other are joined into one (LinkRings), which changes no length. If open paths are fewer,
/// they are used instead.
///
/// Every piece is in exactly one path, and no edge part is used twice. Closed pieces do not change.
/// Cost: the cost of ChooseLinks and SplicedPaths, and O(n + k), n points of the region, k pieces.
std::vector<Path> LinkedPaths(const MultiPolygon& region, std::span<const Piece> pieces,
                              const LinkOptions& options);

}  // namespace slicefarm::infill
