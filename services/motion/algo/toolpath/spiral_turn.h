#pragma once

#include <vector>

#include "common/model/path.h"
#include "common/model/spiral.h"

namespace slicefarm::motion {

/// Straight piece of a turn of a spiral.
struct TurnPiece {
  Point to;
  /// Height of the nozzle in its layer at the end of the piece; 1 is the layer's top.
  double rise = 1;
  double flow = 1;  ///< flow relative to a full bead
};

/// Returns a loop from its start, once around, along which the nozzle rises evenly. A turn that is
/// blended with the turn below begins at the turn's `from`. Each of its points is between the turn
/// below and the loop, at the share of the loop's length up to this point. Points at which the two
/// are not near each other are not moved.
///
/// In the first turn, the flow is the amount that fits below the nozzle, in pieces of at most a
/// millimetre. After the last turn the same loop follows once more at a constant height. Its flow
/// is the amount that is missing in a first turn. `below`: outline of the layer below. REQUIRES:
/// path is closed and of one width.
std::vector<TurnPiece> TurnOf(const Path& path, const SpiralTurn& turn, const MultiPolygon& below);

}  // namespace slicefarm::motion
