#pragma once

#include "common/model/options/flow_table.h"
#include "common/model/path.h"

namespace slicefarm::infill {

/// Returns a width in nm. A bead of this width in a layer of height `to_nm` has `share` times the
/// plastic per length of a bead with width `width_nm` and height `from_nm`.
Coord WidthFor(double share, Coord width_nm, Coord from_nm, Coord to_nm);

/// Reduces the plastic of each line of a path to the share in `table` for the line's length. A line
/// is the part of a path from one bend of more than 45 degrees to the next, so a curve is one line.
/// Links between lines also count as lines. The path's course does not change; the width steps at
/// bends. A closed path may then start at another point, which is the middle of its longest edge.
/// Cost: O(points log table).
void ThinShortLines(const FlowTable& table, Coord height_nm, Path& path);

}  // namespace slicefarm::infill
