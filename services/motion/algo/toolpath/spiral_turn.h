#pragma once

#include <vector>

#include "common/model/path.h"
#include "common/model/spiral.h"

namespace slicefarm::motion {

/// A straight piece of a turn of a spiral.
struct TurnPiece {
  Point to;
  double rise = 1;  ///< how high in its layer the nozzle is at the end of the piece: 1 is its top
  double flow = 1;  ///< of a full bead's
};

/// A loop from its start once around: the nozzle rises evenly along it. Where the turn leads over
/// from one below, each point lies as far from the turn below as it is along the loop, if the two
/// are near each other; the first point is the turn's `from`, where the pieces begin. The flow of
/// a first turn is what fits below it, in pieces of at most a millimetre. After a last turn the
/// same way follows once more, level, with the flow that is left out of the first one.
/// `below`: the outline of the layer below. REQUIRES: path is closed and of one width.
std::vector<TurnPiece> TurnOf(const Path& path, const SpiralTurn& turn, const MultiPolygon& below);

}  // namespace slicefarm::motion
