#pragma once

#include <vector>

#include "common/model/options/region_motion.h"
#include "common/model/path.h"

namespace slicefarm::motion {

/// Straight piece of a loop with a scarf: a seam at which the loop begins as a ramp, and its end
/// overlaps this ramp.
struct ScarfPiece {
  Point to;
  Coord width_nm = 0;
  /// Height of the nozzle at the end of the piece, as a share of the layer's height; 1 is the top.
  double rise = 1;
  double flow = 1;  ///< flow relative to a full bead
};

/// Returns true if the settings give this loop a scarf. This depends on the loop's feature, on
/// whether it surrounds an island or a hole, and on a corner at its start.
bool HasScarf(const Path& path, const ScarfOptions& options);

/// Returns a loop from its start, once around and then again over the length of the scarf. On the
/// first pass over the scarf the nozzle rises evenly from start_height_ratio of the layer to the
/// layer's top. The flow of each piece is the amount that fits below the nozzle at the piece's
/// middle. On the second pass the nozzle is at the top. The flow is then the amount that the first
/// pass lacks, so that both together are one bead. A scarf is at most as long as its loop.
/// REQUIRES: HasScarf.
std::vector<ScarfPiece> ScarfedLoop(const Path& path, const ScarfOptions& options);

}  // namespace slicefarm::motion
