#pragma once

#include <vector>

#include "services/infill/algo/lines/scan_lines.h"

namespace slicefarm::infill {

/// Where a line leaves for its link, and the link's way.
struct SolidTurn {
  double from_back_nm = 0;  ///< the line before ends so far before its crossing
  double to_back_nm = 0;    ///< the line after begins so far behind its crossing
  Polyline way;             ///< one point or more
};

/// The turn from one line of solid infill to the next, by beads that are all as wide as the pitch.
///
/// A link along the edge fills the room before the edge between its own lines; every other such
/// room is without a link, and the two lines beside it leave a wedge there wherever the edge is not
/// square to them. So lines end upright: over their last pitch they bend towards the edge's normal,
/// one into the wedge, the other one away from where its link and line would lie double. The ends
/// of a link move along the edge, both to the same side. By how much, follows from the angle: found
/// by minimising what lies double and eight times what stays empty, of lines on a straight edge at
/// 26 to 88 degrees. Half of the pitch from the edge a turn holds what its room takes, and up to a
/// tenth of a pitch more for each length of edge where that is flat.
///
/// `from` and `to`: crossings next to each other on their ring, `forward`: to is behind from. Cost:
/// O(corners passed).
SolidTurn TurnBetween(const ScanLines& lines, int32_t from, int32_t to, bool forward);

}  // namespace slicefarm::infill
