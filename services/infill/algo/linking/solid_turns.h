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
/// square to them. So the line that leans away from its link bends over its last pitch into the
/// wedge, and that end of the link goes on along the edge. By how much, follows from the angle:
/// found by minimising what lies double and eight times what stays empty, of lines on a straight
/// edge at 26 to 88 degrees, and a little less, after real parts. A bend of the other end too would
/// be a fourth move for each line and 0 to 9 % less that lies double.
///
/// `from` and `to`: crossings next to each other on their ring, `forward`: to is behind from. Cost:
/// O(corners passed).
SolidTurn TurnBetween(const ScanLines& lines, int32_t from, int32_t to, bool forward);

}  // namespace slicefarm::infill
