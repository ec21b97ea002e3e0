#pragma once

#include <functional>
#include <vector>

#include "common/geometry/vector.h"
#include "services/infill/algo/fields/stream_line.h"

namespace slicefarm::infill {

/// Shifts lines aside until each lies in the middle between its neighbours, as far as it can do so
/// without turning much: gaps that open where another line ends, and those that are too narrow for
/// one beside them, are shared out among several lines. Where neighbours lie evenly nothing moves.
///
/// Shifts are relaxed in up to 60 rounds. In each, a node is drawn to the place where the gaps to
/// both sides are to each other as `separation_mm` is there, and the shifts of a line are smoothed
/// along it, some separations far. Nodes with a neighbour on one side only stay with their line.
/// Rounds end where the shifts turn the lines by 0.7 degrees, root of the mean square; those of the
/// last one are taken in part.
/// REQUIRES: separation_mm > 0 on all lines. Cost: in each round, a search of a few segments for
/// each node, of which there are two in a separation.
void EvenGaps(const std::function<double(Vector2)>& separation_mm, std::vector<StreamLine>& lines);

}  // namespace slicefarm::infill
