#pragma once

#include "common/model/options/flow_table.h"
#include "common/model/path.h"

namespace slicefarm::infill {

/// Returns the width that a bead needs in a layer of height `to_nm` to have `share` of the plastic
/// of a bead with width `width_nm` and height `from_nm`.
Coord WidthFor(double share, Coord width_nm, Coord from_nm, Coord to_nm);

/// Reduces the plastic of each line of a path to the share in `table` for the line's length. A line
/// reaches from one bend of more than 45 degrees to the next, so that a curve counts as a whole.
/// Links between lines are also lines. The path's course does not change; its width steps at bends.
/// A closed path may begin inside of a line. Cost: O(points log table).
void ThinShortLines(const FlowTable& table, Coord height_nm, Path& path);

}  // namespace slicefarm::infill
