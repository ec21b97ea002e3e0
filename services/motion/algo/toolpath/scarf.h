#pragma once

#include <vector>

#include "common/model/options/region_speeds.h"
#include "common/model/path.h"

namespace slicefarm::motion {

/// A straight piece of a loop that is printed with a scarf.
struct ScarfPiece {
  Point to;
  Coord width_nm = 0;
  double rise = 1;  ///< how high in its layer the nozzle is at the end of the piece: 1 is its top
  double flow = 1;  ///< of a full bead's
};

/// Whether this loop gets a scarf: its feature, whether it runs around an island or a hole, and
/// whether it starts at a corner.
bool HasScarf(const Path& path, const ScarfOptions& options);

/// A loop from its start, once around and on over its beginning. On the first pass over the scarf
/// the nozzle rises evenly from start_height_ratio of the layer to its top, and the flow is what
/// fits below it: of each piece, that of its middle. On the second one the nozzle stays and the
/// flow is what the first one left out, so that both together are one bead. A loop that is shorter
/// than the scarf has one of its own length. REQUIRES: HasScarf.
std::vector<ScarfPiece> ScarfedLoop(const Path& path, const ScarfOptions& options);

}  // namespace slicefarm::motion
