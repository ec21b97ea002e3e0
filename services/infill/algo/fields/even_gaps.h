#pragma once

#include <functional>
#include <vector>

#include "common/geometry/vector.h"
#include "services/infill/algo/fields/stream_line.h"

namespace slicefarm::infill {

/// Shifts lines sideways until each line is in the middle between its neighbours, as far as this is
/// possible without bending lines much. These shifts distribute two kinds of wrong gaps over
/// several lines: a gap beyond the end of another line, and a gap too wide for two lines but too
/// narrow for three. Lines with even gaps do not move. `separation_mm`: requested distance between
/// lines at a point, in mm.
///
/// Shifts are relaxed in up to 60 rounds. In each round, a node of a line moves towards the point
/// at which the gaps on its two sides have the ratio of `separation_mm` on these sides. The shifts
/// are then smoothed along each line, over some separations. A node with a neighbour on only one
/// side follows the smoothed shift of its line. Rounds stop when the shifts turn the lines by 0.7
/// degrees (root mean square). The last round is then scaled back to this angle. REQUIRES:
/// separation_mm > 0 on all lines. Cost: in each round, a search of a few segments for each node; a
/// line has two nodes per separation.
void EvenGaps(const std::function<double(Vector2)>& separation_mm, std::vector<StreamLine>& lines);

}  // namespace slicefarm::infill
