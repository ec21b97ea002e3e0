#pragma once

#include <vector>

#include "common/model/options/region_motion.h"
#include "common/model/path.h"

namespace slicefarm::motion {

/// Straight piece of a loop with a scarf.
struct ScarfPiece {
  Point to;
  Coord width_nm = 0;
  /// Height of the nozzle in its layer at the end of the piece; 1 is the layer's top.
  double rise = 1;
  double flow = 1;  ///< flow relative to a full bead
};

/// Returns true if this loop gets a scarf. This depends on its feature, on its direction around an
/// island or a hole, and on a corner at its start.
bool HasScarf(const Path& path, const ScarfOptions& options);

/// Returns a loop from its start, once around and then again over its beginning. On the first pass
/// over the scarf the nozzle rises evenly from start_height_ratio of the layer to the layer's top.
/// The flow of each piece is the amount that fits below the nozzle at the piece's middle. On the
/// second pass the nozzle stays at the top. The flow is then the amount missing from the first
/// pass, so that both together are one bead. A loop shorter than the scarf gets a scarf of its own
/// length. REQUIRES: HasScarf.
std::vector<ScarfPiece> ScarfedLoop(const Path& path, const ScarfOptions& options);

}  // namespace slicefarm::motion
