#pragma once

#include "common/model/options/flow_table.h"
#include "common/model/path.h"

namespace slicefarm::infill {

/// The width, in a layer that is `to_nm` high, of a bead with `share` of the plastic of one that is
/// `width_nm` wide and `from_nm` high.
Coord WidthFor(double share, Coord width_nm, Coord from_nm, Coord to_nm);

/// Gives each line of a path the part of its plastic that the table has for its length. A line goes
/// from one turn of more than 45 degrees to the next one, so that curves count as a whole; links
/// between lines are lines themselves. The path goes where it went: at turns its width steps. A
/// closed path begins inside of a line. Cost: O(points log table).
void ThinShortLines(const FlowTable& table, Coord height_nm, Path& path);

}  // namespace slicefarm::infill
