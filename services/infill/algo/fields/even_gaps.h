#pragma once

#include <functional>
#include <vector>

#include "common/geometry/vector.h"
#include "services/infill/algo/fields/stream_line.h"

namespace slicefarm::infill {

/// Shifts lines sideways until each line is in the middle between its neighbours, as far as this is
/// possible without bending lines much. Two kinds of wrong gaps are distributed over several lines:
/// a gap that opens at the end of another line, and a gap that is too narrow for a further line.
/// Lines with even gaps do not move.
///
/// Shifts are relaxed in up to 60 rounds. In each round, a node moves towards the point at which
/// the gaps on its two sides have the ratio of `separation_mm` on these sides. The shifts of a line
/// are then smoothed along the line, over some separations. A node with a neighbour on only one
/// side moves with its line. Rounds stop when the shifts turn the lines by 0.7 degrees (root mean
/// square). Only a fraction of the last round's shifts is applied. REQUIRES: separation_mm > 0 on
/// all lines. Cost: in each round, a search of a few segments for each node; a line has two nodes
/// per separation.
void EvenGaps(const std::function<double(Vector2)>& separation_mm, std::vector<StreamLine>& lines);

}  // namespace slicefarm::infill
