#pragma once

#include <vector>

#include "common/model/options/motion_options.h"
#include "common/model/path.h"
#include "common/model/spiral.h"

namespace slicefarm::motion {

/// Straight piece of a turn: one loop of a spiral around the part (spiral vase).
struct TurnPiece {
  Point to;
  /// Height of the nozzle at the end of the piece, as a share of the layer's height; 1 is the top.
  double rise = 1;
  double flow = 1;  ///< flow relative to a full bead
};

/// Returns one turn: a loop from its start, once around, along which the nozzle rises evenly. If
/// the turn is blended with the turn below, it begins at `turn.from`. A point at the share s of the
/// loop's length is then moved: it is at the share s of the line from the nearest point of the turn
/// below to the loop. Points that are farther from the turn below than the options' reach are not
/// moved.
///
/// In the first turn, the flow is the amount that fits below the nozzle, in pieces of at most a
/// millimetre. If `turn` is the last one, the same loop follows once more at a constant height. Its
/// flow is the amount that is missing in a first turn. The options may set the flow at the start
/// and at the end to more than 0. `below`: outline of the layer below.
/// REQUIRES: path is closed and has one width.
std::vector<TurnPiece> TurnOf(const Path& path, const SpiralTurn& turn, const MultiPolygon& below,
                              const SpiralMotion& options = {});

}  // namespace slicefarm::motion
